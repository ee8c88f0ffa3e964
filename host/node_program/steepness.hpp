// Which shapes' maps squash so much that single precision needs care on the way into their cells
// (dsp_kernels/steepness).
#pragma once

#include "host/compiled/compiled_scene.hpp"

namespace pxm::host {

/// A map is steep that squashes so many times more in one direction than in another. (The alarm
/// steep_maps begins there: docs/alarms.md.)
inline constexpr double least_steep = 512;

/// For every shape, whether some cell that eye rays may look into could be so thin that a ray's
/// direction in its coordinates has no square in single precision. What singular maps lose does not
/// count: their cells keep a thickness.
[[nodiscard]] std::vector<bool> steep_shapes(const CompiledScene& scene);

}  // namespace pxm::host
