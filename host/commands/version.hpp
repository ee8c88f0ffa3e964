// `pxm --version`, and with --json what the program was built of and what was left out.
#pragma once

#include <string>

namespace pxm::host {

/// The version, the libraries that are required, and a line for each thing that was left out.
[[nodiscard]] std::string version_text();

/// One object (docs/command-line.md).
[[nodiscard]] std::string version_json();

}  // namespace pxm::host
