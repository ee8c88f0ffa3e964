// Text from a file made fit for a terminal: no control bytes, no broken UTF-8, no endless words.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace pxm::host {

/// The bytes of the printable character that starts at text[at]: 1 to 4, or 0 if none does
/// (control characters, broken UTF-8, marks that reorder text).
[[nodiscard]] std::size_t printable_length(std::string_view text, std::size_t at);

/// The text with every byte that cannot be shown as '?', cut after about `limit` bytes with "...".
[[nodiscard]] std::string printable(std::string_view text, std::size_t limit = 40);

/// The same of a text of lines: their ends and tabulators stay, and nothing is cut.
[[nodiscard]] std::string printable_lines(std::string_view text);

/// A path or a file's name as messages show it: cut only beyond what a system takes as one name.
[[nodiscard]] std::string printable_path(std::string_view path);

}  // namespace pxm::host
