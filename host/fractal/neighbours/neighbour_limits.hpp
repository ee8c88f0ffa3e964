// How far the search for neighbours goes, and whether it may begin.
#pragma once

#include <cstddef>

namespace pxm::host {

/// Counts, not times: the same system gives the same result.
struct NeighbourLimits {
    std::size_t types = 10'000;      // of neighbours, at most
    std::size_t steps = 10'000'000;  // pairs of cells compared; more for one in exact numbers
    bool as_written = true;  // false: numbers of the scene's text were replaced from outside
};

}  // namespace pxm::host
