// What CLI11 checks of an option's text while it reads the command line.
#pragma once

#include <CLI/CLI.hpp>

namespace pxm::host {

/// A finite number greater than 0.
[[nodiscard]] CLI::Validator positive_number();
/// A number in 0..1.
[[nodiscard]] CLI::Validator share();
/// A text that is not empty, as "$FORGOTTEN" would be.
[[nodiscard]] CLI::Validator some_text();

}  // namespace pxm::host
