// Cost models of the machine from JSON files (docs/machine.md, "Counted
// time").
#pragma once

#include <string>

#include "pxm/cost.hpp"

namespace pxm::host {

/// Reads a cost model. Throws Error: a file that cannot be read (4); one that is not JSON, or with
/// an entry that is missing, unknown, negative or not a number (2, naming the entry).
[[nodiscard]] CostModel read_cost_model(const std::string& path);

/// The same from a text; `path` is for messages.
[[nodiscard]] CostModel parse_cost_model(const std::string& text, const std::string& path);

}  // namespace pxm::host
