// Which images of a system's maps are proven to have no common point, by balls and boxes around
// smaller and smaller cells, in numbers that are known in balls of certified radius.
#pragma once

#include <array>
#include <vector>

#include "host/fractal/bounds/bounds.hpp"
#include "host/fractal/exact/ball_system.hpp"
#include "host/fractal/system/rifs.hpp"

namespace pxm::host {

/// Per follow set, pairs of its maps whose images were not told apart.
using PairsOfMaps = std::vector<std::vector<std::array<int, 2>>>;

/// `bounds` as from bound(), of attractors no further from that of the balls than a millionth of
/// each ball's radius. Cells down to that part of the size are looked at, and a bounded number.
[[nodiscard]] PairsOfMaps not_told_apart(const exact::BallMaps& balls, const Rifs& rifs,
                                         const std::vector<Bounds>& bounds, double smallest);

}  // namespace pxm::host
