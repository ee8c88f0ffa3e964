// Planes and textures of a scene to what the nodes need of them: frames in scene units, the sizes
// of an image, a flat system with its balls.
#pragma once

#include <map>
#include <string>

#include "host/compile/lifted_fractal.hpp"
#include "host/compile/view.hpp"
#include "host/compiled/compiled_scene.hpp"
#include "host/scene/diagnostics.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {

/// Fills in planes, textures and texture memory of `out`, whose unit is known. Only textures that
/// a plane uses are looked at. An ifs that is not flat is an error in `diagnostics`; a file that
/// cannot be used throws Error(ErrorKind::file).
void compile_floor(const Scene& scene, const View& view,
                   const std::map<std::string, Fractal>& fractals, CompiledScene& out,
                   Diagnostics& diagnostics);

}  // namespace pxm::host
