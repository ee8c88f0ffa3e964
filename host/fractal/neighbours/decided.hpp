// An answer that may be open, with its reason either way.
#pragma once

#include <optional>
#include <string>

namespace pxm::host {

/// Something decided, or nothing; and why.
template <class Value>
struct Decided {
    std::optional<Value> value;  // nothing: it is open
    std::string why;             // the proof, or what is in its way
};

}  // namespace pxm::host
