// The dimensions of an attractor (Ch. 5, Sec. 6.4), and what is known of them: which are exact for
// this system, and why.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/fractal/dimension/affinity.hpp"
#include "host/fractal/dimension/box_counting.hpp"
#include "host/fractal/dimension/open_set.hpp"
#include "host/fractal/system/growth.hpp"
#include "host/fractal/system/rifs.hpp"

namespace pxm::host {
/// All that is found out about the dimensions of one attractor.
struct Dimensions {
    std::optional<Interval> similarity;  // of systems of similarities (Eq. 5.19)
    Affinity affinity;                   // of any maps, from above
    BoxCounting box_counting;            // as it is measured
    int hull = 3;                        // dimensions of the line, plane or space that it lies in
    double upper = 3;  // the Hausdorff and box-counting dimensions are not larger: proven
    std::optional<double> exact;  // both are this, if that is known
    std::string meaning;          // what is known of them, and why
};

/// All but what box counting measures. Preconditions: the system contracts, and every follow set is
/// reached from the start. The meaning is that without knowledge of the attractor's topology.
[[nodiscard]] Dimensions dimensions(const Rifs& rifs, OpenSetCondition condition);

/// What follows once it is known whether the attractor is totally disconnected.
void add_topology(Dimensions& found, const std::optional<bool>& totally_disconnected);

}  // namespace pxm::host
