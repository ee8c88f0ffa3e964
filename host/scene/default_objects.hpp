// The objects of a scene: its object blocks, or one object per ifs block where it has none.
#pragma once

#include <vector>

#include "host/scene/scene.hpp"

namespace pxm::host {

[[nodiscard]] std::vector<ObjectBlock> objects_of(const Scene& scene);

}  // namespace pxm::host
