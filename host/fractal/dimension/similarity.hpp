// The similarity dimension: Moran's equation sum r_i^d = 1 (Eq. 5.19); with a graph, the d at which
// the matrix of the sums of r_i^d between follow sets has the spectral radius 1.
#pragma once

#include <optional>
#include <vector>

#include "host/fractal/system/growth.hpp"
#include "host/fractal/system/rifs.hpp"

namespace pxm::host {

/// Nothing unless every map is a similitude. Precondition: the system contracts, and every follow
/// set is reached from the start.
[[nodiscard]] std::optional<Interval> similarity_dimension(const Rifs& rifs);

/// The same for any ratios of the maps, known up to a relative `error`.
[[nodiscard]] Interval exponent_of_ratios(const Rifs& rifs, const std::vector<double>& log_ratio,
                                          double error);

}  // namespace pxm::host
