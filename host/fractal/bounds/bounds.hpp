// Bounding volumes that provably contain the attractor (Ch. 14, and thesis-notes "After the
// thesis"). One ball and one box per follow set: for what may stand inside a map.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "host/fractal/system/contraction.hpp"
#include "host/fractal/system/rifs.hpp"

namespace pxm::host {
/// A ball in the world of a system.
struct Ball {
    glm::dvec3 center{0.0};  // its middle
    double radius = 0;       // 0 or more
};
/// A box along the axes.
struct Box {
    glm::dvec3 low{0.0};   // its corner with the least of each coordinate
    glm::dvec3 high{0.0};  // and that with the greatest
};

/// Bounds of E_s for one follow set s, for the maps as the doubles that they are. Each contains E_s
/// with a margin of about 1e-9; where rounding may have taken more than that, it is larger by that.
struct Bounds {
    Ball ball;  // one of the smallest
    Box box;    // the smallest along the axes
    /// Without the margin, ball.radius is at most (1 + ball_slack) times that of the smallest ball
    /// around points of E_s, as double has these.
    double ball_slack = 0;
};

/// Bounds for every follow set. Precondition: the system contracts (`proof` is not none).
[[nodiscard]] std::vector<Bounds> bound(const Rifs& rifs, const Contraction& contraction);

}  // namespace pxm::host
