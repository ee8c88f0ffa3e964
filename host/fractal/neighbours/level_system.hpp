// A system whose ratios are powers of one number as a system with a graph whose maps all have that
// ratio: a map of the kth power becomes k maps one after another, between pieces that wait. Then
// cells of one level are of one size, and words of different lengths that are the same map meet at
// one level [NW01].
#pragma once

#include <optional>
#include <vector>

#include "host/fractal/bounds/bounds.hpp"
#include "host/fractal/exact/exact_system.hpp"
#include "host/fractal/system/rifs.hpp"

namespace pxm::host {

struct LevelSystem {
    exact::ExactSystem system;  // its `numbers` are not set
    Rifs rifs;                  // the graph alone; the first follow set is the whole
    std::vector<Bounds> bounds;
    double log_ratio = 0;
};

/// Nothing if the ratios are no small powers of one number. Preconditions: the system is one follow
/// set of similitudes that have inverses.
[[nodiscard]] std::optional<LevelSystem> level_system(const exact::ExactSystem& system,
                                                      const Rifs& rifs, const Bounds& bounds);

}  // namespace pxm::host
