// A system whose numbers are known in balls: those of the scene's text, or all numbers near the
// doubles that pictures are made of.
#pragma once

#include <optional>
#include <vector>

#include "host/fractal/exact/real_ball.hpp"
#include "host/fractal/system/rifs.hpp"

namespace pxm::host::exact {

struct BallMaps {
    std::vector<BallEntries> maps;
    /// Per map: its factor up to its sign, if it is a similitude whatever its numbers are.
    std::vector<std::optional<RealBall>> ratio;
};

/// All maps whose numbers are within 10^-12 of the largest beside them of the rounded ones. What
/// is 0 in double is left 0 in balls: a map that keeps a plane keeps it.
[[nodiscard]] BallMaps balls_around(const Rifs& rifs);

/// Digits of all entries that the balls tell, against the largest of each map; 60 at most.
[[nodiscard]] int digits_of(const BallMaps& balls);

/// The attractors of all systems in the balls are no further from that of the rounded maps than
/// this, over the largest distance from the origin that it has, or 1. Throws NotExact where the
/// balls are not around the rounded maps, nearly.
[[nodiscard]] double offset_of(const BallMaps& balls, const Rifs& rifs);

}  // namespace pxm::host::exact
