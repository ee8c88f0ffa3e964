// Cells as samples of the distance to the union of them. A cell looks at cubes of samples and
// halves them down to 8 a side where its surface may be near: what is far outside is left alone,
// what is deep inside is filled as a whole.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <vector>

#include "host/export/cells.hpp"
#include "host/export/solid.hpp"
#include "host/export/vdb_library.hpp"

namespace pxm::host {

/// So much larger, in voxels, is a cell than it is: cells that touch hang together whatever
/// rounding does to the sample between them.
inline constexpr double cell_growth = 0x1p-10;

class Voxels {
  public:
    /// `look` is called now and then, and may throw. All must outlive it.
    Voxels(const ExportSystem& system, const SampleGrid& grid, LevelSet& level_set,
           const std::function<void()>& look);

    /// A cell of that system.
    void add(const Cell& cell);

  private:
    /// A solid, and what leads from samples to it.
    struct Placed {
        const Solid& solid;
        Affine back;
        double scale = 1;  // of distances
    };

    void divide(const Placed& placed, const glm::ivec3& low, int edge);
    void sample(const Placed& placed, const glm::ivec3& low);

    const ExportSystem& system_;
    Affine to_samples_;  // from the world
    LevelSet& level_set_;
    const std::function<void()>& look_;
    std::vector<Solid> solids_;  // of the sets, as they stand
    glm::ivec3 low_{0};          // the samples that the cell can reach
    glm::ivec3 high_{0};
};

}  // namespace pxm::host
