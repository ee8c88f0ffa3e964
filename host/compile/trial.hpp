// What bounding volumes cost, by trial: a few rays from several sides, rendered natively. The mean
// shadow of a volume (Cauchy: a quarter of its surface) tells how many cells rays would meet if
// none ended before; where rays end is what only a trial tells.
#pragma once

#include <limits>
#include <span>

#include "host/compiled/compiled_scene.hpp"

namespace pxm::host {

/// A trial of a shape's volumes. Loose volumes cost many thousand times what good ones do, so a
/// trial goes only as far as somebody wants to know.
class Trial {
  public:
    /// Rays cross the unit ball of the shape's coordinates; a cell is terminal at 1/256 of it or
    /// after `levels` maps.
    Trial(const CompiledShape& shape, std::uint32_t levels);

    /// What tests of cells cost a ray on average, in tests of a sphere, if that is below `enough`;
    /// else some number from `enough` on, and no larger than the cost.
    [[nodiscard]] double cost(double enough = std::numeric_limits<double>::infinity());

  private:
    void go_on();

    CompiledScene scene_;
    double share_ = 0;  // of the cost: one test
    long next_ = 0;     // row of rays, of all sides
    double tests_ = 0;
};

/// Whether the first costs less than `factor` times the second. No trial goes much farther than
/// twice the smaller cost.
[[nodiscard]] bool is_cheaper(Trial& one, double factor, Trial& other);

/// The share of rays through the volume of a follow set that meet a cell of an eighth of its size
/// in it: the mean over views along some directions, or from several sides if there are none.
[[nodiscard]] double mean_coverage(const CompiledShape& shape, std::size_t set,
                                   std::span<const glm::dvec3> views);

}  // namespace pxm::host
