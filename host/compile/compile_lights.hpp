// The lights of a scene as its nodes see them.
#pragma once

#include <vector>

#include "host/compiled/compiled_scene.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {

/// The light blocks in scene units (the eye at the origin), or the one default light: white,
/// directional, from (0.5, 1, -0.7), without shadows.
[[nodiscard]] std::vector<CompiledLight> compile_lights(const Scene& scene, const glm::dvec3& eye,
                                                        double unit);

}  // namespace pxm::host
