// A text without what others need not read in it.
#pragma once

#include <string>

namespace pxm::host {

/// Precondition: `part` is not empty.
[[nodiscard]] inline std::string without(std::string text, const std::string& part) {
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at))
        text.erase(at, part.size());
    return text;
}

}  // namespace pxm::host
