// The objects of a scene with the shapes that stand for their cells.
#pragma once

#include <optional>
#include <vector>

#include "host/export/cells.hpp"
#include "host/scene/diagnostics.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {

/// Every object of a scene that was checked. `kind` as render's --volume has it; `shape`, if there
/// is one, stands for each cell instead of its bounding volume. Errors go to `diagnostics`, also if
/// there is no object.
[[nodiscard]] std::vector<ExportedObject> exported_objects(const Scene& scene, VolumeKind kind,
                                                           const std::optional<Mesh>& shape,
                                                           Diagnostics& diagnostics);

}  // namespace pxm::host
