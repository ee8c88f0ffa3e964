// `pxm --version`, and with --json what the program was built of and what was left out.
#pragma once

#include <string>

namespace pxm::host {

/// The version, and the libraries that are required.
[[nodiscard]] std::string version_text();

/// One object (docs/command-line.md).
[[nodiscard]] std::string version_json();

}  // namespace pxm::host
