// Is the attractor totally disconnected? Sec. 3.7, where it can be decided.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/fractal/bounds/bounds.hpp"
#include "host/fractal/system/rifs.hpp"

namespace pxm::host {

struct DisconnectedFinding {                   // the answer
    std::optional<bool> totally_disconnected;  // nothing: not decided
    std::string why;                           // the proof, or what it would take
};

/// `bounds` as from bound(), `dimension_upper` no smaller than its Hausdorff dimension.
/// Precondition: the system contracts, and every follow set is reached from the start.
[[nodiscard]] DisconnectedFinding decide_disconnected(const Rifs& rifs,
                                                      const std::vector<Bounds>& bounds,
                                                      double dimension_upper);

}  // namespace pxm::host
