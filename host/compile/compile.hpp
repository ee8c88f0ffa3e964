// Scene to compiled scene: defaults, graphs, contraction, lifting, bounds, volumes, camera (in
// double).
#pragma once

#include "host/compiled/compiled_scene.hpp"
#include "host/scene/diagnostics.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {

/// What becomes of cells that are too near the eye for the nodes' numbers (host/compile/reroot).
enum class NearCells { replaced, kept };

/// Compiles a scene that check_scene found right. `zoom` moves the eye to look + (eye - look) /
/// zoom. Systems that do not contract and graphs that end are errors in `diagnostics`; volumes that
/// were replaced are warnings. The result is usable only if no error was added.
[[nodiscard]] CompiledScene compile(const Scene& scene, double zoom, Diagnostics& diagnostics,
                                    NearCells near_cells = NearCells::replaced);

/// The scene's camera with its eye and the point that it looks at, also where the scene leaves them
/// to its objects: for a scene of some of these. Errors as of compile().
[[nodiscard]] CameraBlock placed_camera(const Scene& scene, double zoom, Diagnostics& diagnostics);

}  // namespace pxm::host
