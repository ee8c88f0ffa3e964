// How much what a system makes depends on what its maps are: bounds of sums over all lengths of
// words.
#pragma once

#include "host/fractal/system/rifs.hpp"

namespace pxm::host {

/// Sums over all lengths of the largest Lipschitz constant of words that long, and of its square;
/// infinite where no word of moderate length is known to contract. The first bounds how far the
/// attractor moves, over how far its maps do.
struct Sensitivity {
    double lipschitz = 0;
    double squares = 0;
};

[[nodiscard]] Sensitivity sensitivity(const Rifs& rifs);

}  // namespace pxm::host
