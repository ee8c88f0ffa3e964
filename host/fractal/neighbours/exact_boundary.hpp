// The dimension of an attractor's boundary: where its cells meet their neighbours, a set with the
// graph of neighbours for its graph.
#pragma once

#include "host/fractal/neighbours/decided.hpp"
#include "host/fractal/neighbours/exact_findings.hpp"
#include "host/fractal/neighbours/searched_system.hpp"

namespace pxm::host {

/// `found` has what was decided before: whether there is an inside, and the dimension.
[[nodiscard]] Decided<double> exact_boundary(const SearchedSystem& searched,
                                             const ExactFindings& found);

}  // namespace pxm::host
