// Which objects consist of homotheties alone, and their tables (Ch. 13: where no map turns a ray,
// its direction is the same in all cells).
#pragma once

#include "host/wide/tables/wide_scene.hpp"

namespace pxm::host::wide {

/// Whether all maps are homotheties of positive ratio, the cells of all maps lie within their
/// parents', all volumes are balls or all are boxes of one shape, and the object itself is not
/// squashed (balls stay balls).
[[nodiscard]] bool is_of_homotheties(const CompiledScene& scene, const CompiledObject& object);

/// Fills in the homothety tables of the sets of such objects. One whose cells have more children
/// than a ray keeps of an opened cell (opened_cell_room), and which is no grid, is no object
/// of homotheties any more.
void tabulate_homotheties(WideScene& scene);

}  // namespace pxm::host::wide
