// What FLINT and Arb keep for each thread that computes with them: numbers that were freed, for the
// next ones.
#pragma once

#include <flint/flint.h>

namespace pxm::host::exact {

/// Gives it back when this thread ends. To be called before a thread's first number is made, as
/// often as one likes.
inline void give_back_with_thread() {
    struct AtEnd {
        ~AtEnd() { flint_cleanup(); }
    };
    thread_local const AtEnd at_end;
    static_cast<void>(at_end);
}

}  // namespace pxm::host::exact
