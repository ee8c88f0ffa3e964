// An answer that may be open, with its reason either way.
#pragma once

#include <optional>
#include <string>

namespace pxm::host {

/// Something decided, or nothing; and why.
template <class Value>
struct Decided {
    std::optional<Value> value;
    std::string why;
};

}  // namespace pxm::host
