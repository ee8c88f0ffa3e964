// First, loose volumes that contain the attractor: balls (ellipsoids, where only those contract)
// whose images lie inside them. Whatever way they were found, that alone makes them contain every
// E_s.
#pragma once

#include <vector>

#include "host/fractal/bounds/bounds.hpp"
#include "host/fractal/bounds/inner_points.hpp"

namespace pxm::host {

/// A ball and a box around each E_s, possibly much too large; infinite if double cannot hold them
/// or if `contraction` is no proof for `rifs`. `inner` are points of each E_s. That every image
/// lies inside was checked in brackets.
[[nodiscard]] std::vector<Bounds> invariant_volumes(const Rifs& rifs,
                                                    const Contraction& contraction,
                                                    const std::vector<Points>& inner);

}  // namespace pxm::host
