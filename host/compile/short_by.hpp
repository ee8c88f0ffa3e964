// Whether a declared bounding volume contains the attractor, and if not, what sticks out of it.
#pragma once

#include <vector>

#include "host/fractal/bounds/bounds.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {

/// By how much E_s of follow set `set` sticks out of a declared volume: 0 (or less) if it is
/// contained or sticks out by no more than 1e-9 of its size, which is what the digits of a volume
/// that touches may leave; else the largest distance found, for all but a sphere from one of the
/// surfaces that bound the volume; an upper bound, never too small. 0 for volumes that are
/// computed. `bounds` as from bound().
[[nodiscard]] double short_by(const Rifs& rifs, const std::vector<Bounds>& bounds, int set,
                              const DeclaredVolume& volume);

/// The same for every follow set.
[[nodiscard]] std::vector<double> short_by(const Rifs& rifs, const std::vector<Bounds>& bounds,
                                           const DeclaredVolume& volume);

}  // namespace pxm::host
