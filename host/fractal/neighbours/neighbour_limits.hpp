// How far the search for neighbours goes.
#pragma once

#include <cstddef>

namespace pxm::host {

/// Counts, not times: the same system gives the same result.
struct NeighbourLimits {
    std::size_t types = 10'000;
    std::size_t steps = 3'000'000;  // candidates looked at; one in exact numbers counts tenfold
};

}  // namespace pxm::host
