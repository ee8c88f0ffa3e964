// Scene to text: what parse(print(scene)) gives back is the same scene.
#pragma once

#include <string>

#include "host/scene/scene.hpp"

namespace pxm::host {

/// The scene in the scene language, one directive a line, numbers in the shortest form that reads
/// back the same.
[[nodiscard]] std::string print_scene(const Scene& scene);

}  // namespace pxm::host
