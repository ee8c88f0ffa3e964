// The dimensions of an attractor in their order, Hausdorff <= box-counting <= affinity <=
// similarity, with what is known of each and of which are equal, and how it is known.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "host/inspect/inspection.hpp"

namespace pxm::host {

/// exact: decided in the scene's very numbers. proven: with bounds of all errors. numerical: from
/// rounded numbers, or measured.
enum class Known { exact, proven, numerical, unknown };

[[nodiscard]] const char* known_name(Known known);

struct OrderedDimension {
    const char* name = "";
    std::optional<double> value;
    Known known = Known::unknown;
    std::string why;
};

/// Between one dimension and the next.
struct DimensionLink {
    const char* relation = "<=";  // or = or <
    Known known = Known::unknown;
    std::string why;
};

struct DimensionOrder {
    std::array<OrderedDimension, 4> dimensions;
    std::array<DimensionLink, 3> links;
};

[[nodiscard]] DimensionOrder dimension_order(const IfsFacts& ifs);

}  // namespace pxm::host
