// How far the search for neighbours goes.
#pragma once

#include <cstddef>

namespace pxm::host {

/// Counts, not times: the same system gives the same result.
struct NeighbourLimits {
    std::size_t types = 10'000;
    std::size_t steps = 10'000'000;  // pairs of cells compared; more for one in exact numbers
};

}  // namespace pxm::host
