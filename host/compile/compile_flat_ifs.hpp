// A flat system for point inclusion (Alg. 7.2): what an ifs does to x and y, in coordinates that
// begin at the attractor's box and are as long as its longer side.
#pragma once

#include <glm/vec2.hpp>

#include "host/compile/lifted_fractal.hpp"
#include "host/compiled/compiled_floor.hpp"

namespace pxm::host {

/// Fills in the system of a texture such that the box of the attractor fills a repeat. Returns the
/// size of that box, 0,0 if z takes part in x or y.
[[nodiscard]] glm::dvec2 compile_flat_ifs(const Fractal& fractal, CompiledTexture& texture);

}  // namespace pxm::host
