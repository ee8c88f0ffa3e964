#include "host/compile/placed.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "host/compile/volumes.hpp"
#include "host/compiled/bounding_volume.hpp"
#include "host/math/lipschitz.hpp"

namespace pxm::host {

Ball Placed::own_ball() const {
    if (fractal == nullptr) return ball_around(primitive_volume(*block->volume));
    return fractal->bounds[static_cast<std::size_t>(fractal->rifs.start)].ball;
}

Ball Placed::world_ball() const {
    const Ball ball = own_ball();
    return {instance.point(ball.center), lipschitz_constant(instance) * ball.radius};
}

Ball ball_around(const std::vector<Placed>& objects) {
    if (objects.empty()) return {{0, 0, 0}, 1};
    if (objects.size() == 1) return objects.front().world_ball();
    glm::dvec3 low{INFINITY};
    glm::dvec3 high{-INFINITY};
    for (const Placed& object : objects) {
        const Ball ball = object.world_ball();
        low = glm::min(low, ball.center - ball.radius);
        high = glm::max(high, ball.center + ball.radius);
    }
    Ball all{(low + high) / 2.0, 0};
    for (const Placed& object : objects) {
        const Ball ball = object.world_ball();
        all.radius = std::max(all.radius, glm::distance(all.center, ball.center) + ball.radius);
    }
    return all;
}

}  // namespace pxm::host
