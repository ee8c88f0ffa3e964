// What `pxm inspect --json` writes, with the keys of docs/inspect.md. Keys are added, never
// renamed.
#pragma once

#include <string>

#include "host/inspect/inspection.hpp"

namespace pxm::host {

/// The whole text, with an end of line.
[[nodiscard]] std::string inspect_json(const Inspection& inspection);

}  // namespace pxm::host
