// What must hold of a scene before it is compiled: names, ranges, counts, graphs and contraction,
// and that it asks only for what this version renders.
#pragma once

#include "host/scene/diagnostics.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {

/// Checks names, ranges and graphs of everything in the scene; errors and warnings go to
/// `diagnostics`.
void check_scene(const Scene& scene, Diagnostics& diagnostics);

}  // namespace pxm::host
