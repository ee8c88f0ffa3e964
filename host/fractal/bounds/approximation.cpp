#include "host/fractal/bounds/approximation.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

namespace pxm::host {

double volume_support(const Approximation& known, int set, const glm::dvec3& u) {
    const auto& [ball, box, slack] = known.outer[set];
    const double of_ball = glm::dot(ball.center, u) + ball.radius * glm::length(u);
    const glm::dvec3 corner{u.x > 0 ? box.high.x : box.low.x, u.y > 0 ? box.high.y : box.low.y,
                            u.z > 0 ? box.high.z : box.low.z};
    double reach = std::min({of_ball, glm::dot(corner, u), support(known.oriented[set], u)});
    if (!known.grid.empty()) reach = std::min(reach, known.grid.support(set, u));
    return reach;
}

Approximation approximation(const Rifs& rifs, const std::vector<Bounds>& bounds) {
    Approximation known;
    known.outer = bounds;
    known.inner = inner_points(rifs);
    for (const Bounds& of_set : bounds) known.oriented.push_back(as_oriented(of_set.box));
    return known;
}

OrientedBox as_oriented(const Box& box) { return oriented_box(glm::dmat3{1.0}, box.low, box.high); }

}  // namespace pxm::host
