// The projections of an attractor along axes that all maps keep as directions: attractors
// themselves, whose Hausdorff dimension is no larger.
#pragma once

#include <functional>

#include "host/fractal/exact/exact_system.hpp"
#include "host/fractal/neighbours/decided.hpp"
#include "host/fractal/neighbours/neighbour_limits.hpp"
#include "host/fractal/system/rifs.hpp"

namespace pxm::host {

/// The largest that is decided in exact numbers, if any may be as large as the affinity dimension.
/// `written` reads the maps of `rifs` anew.
[[nodiscard]] Decided<double> shadow_dimension(const std::function<exact::WrittenMaps()>& written,
                                               const Rifs& rifs, const NeighbourLimits& limits);

}  // namespace pxm::host
