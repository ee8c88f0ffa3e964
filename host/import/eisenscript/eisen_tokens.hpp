// The words of an EisenScript file, its comments left out and its #define lines put in.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host/scene/diagnostics.hpp"

namespace pxm::host {

struct EisenToken {
    std::string text;
    Position position;
};

/// Words end at blanks and braces; what stands in [ ] is one word.
[[nodiscard]] std::vector<EisenToken> eisen_tokens(std::string_view text, Diagnostics& diagnostics);

}  // namespace pxm::host
