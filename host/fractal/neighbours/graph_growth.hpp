// The exponent at which the words of a graph neither grow nor fade: the Hausdorff dimension of
// graph-directed sets whose pieces keep apart [MW88].
#pragma once

#include <optional>
#include <vector>

#include "host/fractal/system/growth.hpp"

namespace pxm::host {

/// A step from one state to another that makes cells smaller by exp(log_ratio).
struct GrowthStep {
    int to = 0;
    double log_ratio = 0;
};
using GrowthGraph = std::vector<std::vector<GrowthStep>>;

/// The d at which the matrix of the sums of ratio^d has spectral radius 1; 0 if no component
/// branches; nothing if no path is endless.
[[nodiscard]] std::optional<Interval> growth_exponent(const GrowthGraph& graph);

}  // namespace pxm::host
