// Local covers by area (`covers: area`): what a compiled scene needs for the beams of
// dsp_kernels/beam.hpp.
#pragma once

#include <vector>

#include "host/compiled/compiled_scene.hpp"
#include "host/scene/diagnostics.hpp"

namespace pxm::host {

/// Prepares the scene for beams, with the places that the render block asks for and the mean
/// coverage of each volume. A shape that is `filled` is a solid, a polygon or a surface. More
/// places than a beam has, and translucent objects, are errors. Precondition: the scene's objects
/// and its detail are compiled.
void cover_by_area(const RenderBlock& render, const std::vector<bool>& filled, CompiledScene& scene,
                   Diagnostics& diagnostics);

}  // namespace pxm::host
