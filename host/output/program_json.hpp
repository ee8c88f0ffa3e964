// The node program as JSON, for --stats and for `pxm inspect` (docs/command-line.md).
#pragma once

#include <nlohmann/json.hpp>

#include "host/node_program/link.hpp"

namespace pxm::host {

/// Modules with their bytes and reasons, and what else lies in fast memory.
[[nodiscard]] nlohmann::ordered_json program_json(const NodeProgram& program);

}  // namespace pxm::host
