// What a pixel shows: the cell that its first ray meets, by its word.
#pragma once

#include <optional>
#include <vector>

#include "host/compiled/compiled_scene.hpp"

namespace pxm::host {

struct PickedCell {
    int object = 0;         // number of it in the scene
    std::vector<int> word;  // maps of its system, outermost first; empty for a volume
    double distance = 0;    // from the eye, world units
};

/// Found by the reference kernels in double. Nothing where a plane or the background is seen.
/// Precondition: the pixel lies in the image.
[[nodiscard]] std::optional<PickedCell> pick_cell(const CompiledScene& scene, long x, long y);

}  // namespace pxm::host
