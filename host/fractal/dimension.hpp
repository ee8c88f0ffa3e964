// The dimensions of an attractor (Ch. 5, Sec. 6.4), and what is known of them: which are exact for
// this system, and why.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/fractal/affinity.hpp"
#include "host/fractal/bounds.hpp"
#include "host/fractal/box_counting.hpp"
#include "host/fractal/growth.hpp"
#include "host/fractal/open_set.hpp"
#include "host/fractal/rifs.hpp"

namespace pxm::host {

struct Dimensions {
    std::optional<Interval> similarity;
    Affinity affinity;
    BoxCounting box_counting;
    std::string meaning;  // what they say of the Hausdorff dimension
};

/// Precondition: the system contracts, and every follow set is reached from the start. `bounds` as
/// from bound().
[[nodiscard]] Dimensions dimensions(const Rifs& rifs, const std::vector<Bounds>& bounds,
                                    OpenSetCondition condition);

}  // namespace pxm::host
