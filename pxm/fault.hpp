// What a node cannot do is a value, not an exception: the node halts, the host reports it.
#pragma once

#include <cstdint>
#include <string_view>

namespace pxm {

/// A limit of the machine that was exceeded, or an access outside a bank.
struct Fault {
    int node = 0;           // row * columns + column
    std::string_view bank;  // "front buffer", "back buffer", "z-buffer", "texture", "fast memory"
    std::int64_t wanted_bytes = 0;  // the size, or the end of the access, that was asked for
    std::int64_t limit_bytes = 0;   // that there are
};

}  // namespace pxm
