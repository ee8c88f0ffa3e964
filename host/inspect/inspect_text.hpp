// What `pxm inspect` prints for people: the facts of the JSON, shorter (docs/inspect.md).
#pragma once

#include <string>

#include "host/inspect/inspection.hpp"

namespace pxm::host {

[[nodiscard]] std::string inspect_text(const Inspection& inspection);  // what `pxm inspect` prints

}  // namespace pxm::host
