// The Hausdorff dimension of a system in exact numbers: the similarity dimension where the open-set
// condition holds, and where cells coincide that of the words which equal no earlier one.
#pragma once

#include <array>
#include <vector>

#include "host/fractal/neighbours/decided.hpp"
#include "host/fractal/neighbours/searched_system.hpp"

namespace pxm::host {

struct ExactDimension {
    Decided<double> value;
    /// The system without words that equal an earlier one, if it was needed: per state its maps and
    /// the states that they lead to; the first is that of the whole.
    std::vector<std::vector<std::array<int, 2>>> distinct;
};

/// `overlaps` and `open_set` are what was decided of these.
[[nodiscard]] ExactDimension exact_dimension(const SearchedSystem& searched,
                                             const Decided<bool>& overlaps,
                                             const Decided<bool>& open_set);

}  // namespace pxm::host
