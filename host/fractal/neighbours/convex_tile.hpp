// A tile that is a polytope. The corners are found in exact numbers: points of the attractor whose
// convex hull the maps keep, which is then that of the attractor. If the images of the hull have no
// inside in common and their volumes add up to the hull's, they fill it, and the attractor, of
// which there is only one [Hutchinson81], is the hull.
#pragma once

#include <optional>

#include "host/fractal/exact/exact_system.hpp"

namespace pxm::host {

/// The volume of the attractor if it is a polytope of few corners, rounded; else nothing.
/// Preconditions: the system is one follow set of maps with inverses, and the maps' volumes add up
/// to the whole's.
[[nodiscard]] std::optional<double> convex_volume(const exact::ExactSystem& system);

}  // namespace pxm::host
