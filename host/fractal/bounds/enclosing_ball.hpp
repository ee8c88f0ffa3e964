// The smallest ball around points (Welzl), and around few points exactly.
#pragma once

#include <vector>

#include "host/fractal/bounds/bounds.hpp"
#include "host/fractal/bounds/inner_points.hpp"

namespace pxm::host {

/// The smallest ball that contains the points, up to rounding. No points: the ball of radius 0.
[[nodiscard]] Ball enclosing_ball(Points points);

}  // namespace pxm::host
