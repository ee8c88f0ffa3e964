// The keys of `pxm inspect --json` for what exact numbers decide (docs/inspect.md).
#pragma once

#include <nlohmann/json.hpp>

#include "host/inspect/inspection.hpp"

namespace pxm::host {

/// Adds them to those of the system; some belong to `dimension`, which is there already.
void add_exact_json(const IfsFacts& ifs, nlohmann::ordered_json& json);

}  // namespace pxm::host
