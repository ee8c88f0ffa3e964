// A scene's text laid out anew: what it says and its comments stay, word for word.
#pragma once

#include <string>
#include <string_view>

namespace pxm::host {

/// The text of a scene without mistakes of syntax, formatted: `let`, `include` and blocks begin
/// lines, directives are indented, blanks are those that help reading. Where the author broke lines
/// between values or directives they stay broken, and a block on one line stays there if it fits.
/// Formatting what was formatted changes nothing.
[[nodiscard]] std::string format_scene(std::string_view text);

}  // namespace pxm::host
