#include "host/fractal/bounds/image_box.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

namespace pxm::host {

namespace {

constexpr long work_limit = 5'000'000;  // images taken
constexpr long most_rounds = 400;
constexpr double settled = 1e-8;    // of a box's size: changes below are not worth a round
constexpr double rounding = 1e-14;  // of the coordinates

double sum(const glm::dvec3& v) { return v.x + v.y + v.z; }

/// The box of map(E), E in both the ball and the box.
Box image(const Affine& map, const Bounds& bounds) {
    const glm::dvec3 middle = map.point((bounds.box.low + bounds.box.high) / 2.0);
    const glm::dvec3 center = map.point(bounds.ball.center);
    const glm::dvec3 half = (bounds.box.high - bounds.box.low) / 2.0;
    const glm::dmat3 rows = glm::transpose(map.linear);
    Box box;
    for (int i = 0; i < 3; ++i) {
        const double of_box = sum(glm::abs(rows[i]) * half);
        const double of_ball = glm::length(rows[i]) * bounds.ball.radius;
        const double slack = rounding * (std::abs(middle[i]) + of_box);
        box.low[i] = std::max(middle[i] - of_box, center[i] - of_ball) - slack;
        box.high[i] = std::min(middle[i] + of_box, center[i] + of_ball) + slack;
    }
    return box;
}

/// Shrinks one box and returns by how much, as a share of its size.
double shrink(const Rifs& rifs, std::vector<Bounds>& bounds, int set) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Box images{glm::dvec3{infinity}, glm::dvec3{-infinity}};
    for (const int m : rifs.follow_sets[set].maps) {
        const Box of_map = image(rifs.maps[m], bounds[rifs.follow_of[m]]);
        images.low = glm::min(images.low, of_map.low);
        images.high = glm::max(images.high, of_map.high);
    }
    Box& box = bounds[set].box;
    const Box before = box;
    box.low = glm::max(box.low, images.low);
    box.high = glm::min(box.high, images.high);
    const double moved = sum(box.low - before.low) + sum(before.high - box.high);
    return moved / sum(before.high - before.low);
}

}  // namespace

void shrink_boxes(const Rifs& rifs, std::vector<Bounds>& bounds) {
    long edges = 1;
    for (const FollowSet& set : rifs.follow_sets) edges += static_cast<long>(set.maps.size());
    for (long round = std::clamp<long>(work_limit / edges, 2, most_rounds); round > 0; --round) {
        double largest = 0;
        for (std::size_t s = 0; s < bounds.size(); ++s) {
            largest = std::max(largest, shrink(rifs, bounds, static_cast<int>(s)));
        }
        if (!(largest > settled)) return;
    }
}

}  // namespace pxm::host
