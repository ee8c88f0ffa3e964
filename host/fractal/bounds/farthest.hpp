// How far the attractor reaches from a point: best-first descent with balls and boxes.
#pragma once

#include <glm/vec3.hpp>

#include "host/fractal/bounds/support.hpp"

namespace pxm::host {

/// When the search for the farthest point may stop.
struct FarthestGoal {
    double enough = 0;     // the upper bound is down to this distance
    double tolerance = 0;  // upper and lower bound are this near
    double share = 0;      // ... or this share of lower - enough, if that is larger
    long budget = 0;       // cells looked at
};

/// The largest distance of E_set from `from`: bounds, and the point that has the lower one.
[[nodiscard]] Reach farthest(const Rifs& rifs, const Approximation& known, int set,
                             const glm::dvec3& from, const FarthestGoal& goal);

}  // namespace pxm::host
