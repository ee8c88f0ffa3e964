// Cost models of the machine: the default one, or one from a JSON file (docs/machine.md, "Counted
// time").
#pragma once

#include <string>

#include "pxm/cost.hpp"

namespace pxm::host {

/// A cost table and where it is from: "default", or a file's path.
struct CostModel {
    std::string name;
    CostTable table;
};

[[nodiscard]] CostModel default_cost_model();

/// Reads a cost model. Throws Error: a file that cannot be read (4); one that is no JSON, or with
/// an entry that is missing, unknown, negative or not a number (2, naming the entry).
[[nodiscard]] CostModel read_cost_model(const std::string& path);

/// The same from a text; `path` is for messages.
[[nodiscard]] CostModel parse_cost_model(const std::string& text, const std::string& path);

}  // namespace pxm::host
