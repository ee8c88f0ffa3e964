// What bounding volumes cost, by trial: a few rays from several sides, rendered natively. The mean
// shadow of a volume (Cauchy: a quarter of its surface) tells how many cells rays would meet if
// none ended before; where rays end is what only a trial tells.
#pragma once

#include <span>

#include "host/compiled/compiled_scene.hpp"

namespace pxm::host {

/// What tests of cells cost a ray on average, in tests of a sphere. Rays cross the unit ball of the
/// shape's coordinates; a cell is terminal at 1/256 of it or after `levels` maps.
[[nodiscard]] double trial_cost(const CompiledShape& shape, std::uint32_t levels);

/// The share of rays through the volume of a follow set that meet a cell of an eighth of its size
/// in it: the mean over views along some directions, or from several sides if there are none.
[[nodiscard]] double mean_coverage(const CompiledShape& shape, std::size_t set,
                                   std::span<const glm::dvec3> views);

}  // namespace pxm::host
