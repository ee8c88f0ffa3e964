// Whether a sparse nonnegative matrix grows, by eliminating one follow set after the other: exact
// up to rounding, also along chains and rings that iteration takes long to go around.
#pragma once

#include <vector>

#include "host/fractal/system/growth.hpp"

namespace pxm::host {

/// As growth() on one component, with the same meaning of `error`; unclear where it would take too
/// long.
[[nodiscard]] Growth growth_by_elimination(const StepMatrix& matrix, const std::vector<int>& sets,
                                           double error);

}  // namespace pxm::host
