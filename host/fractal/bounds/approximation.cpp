#include "host/fractal/bounds/approximation.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

namespace pxm::host {

namespace {

double support_terms(const OrientedBox& box, const glm::dvec3& u) {
    double terms = dot_of_parts(u, box.center);
    for (const glm::dvec3& half : box.half) terms += dot_of_parts(u, half);
    return terms;
}

}  // namespace

Rounded volume_support(const Approximation& known, int set, const glm::dvec3& u) {
    const auto& [ball, box, slack] = known.outer[set];
    const OrientedBox& oriented = known.oriented[set];
    const double of_ball = glm::dot(ball.center, u) + ball.radius * glm::length(u);
    const glm::dvec3 corner{u.x > 0 ? box.high.x : box.low.x, u.y > 0 ? box.high.y : box.low.y,
                            u.z > 0 ? box.high.z : box.low.z};
    const double of_box = glm::dot(corner, u);
    double reach = std::min({of_ball, of_box, support(oriented, u)});
    if (!known.grid.empty()) {
        const double of_grid = known.grid.support(set, u);
        if (of_grid < reach) return {of_grid, known.grid.rounding(set, u)};
    }
    // The volume that allows least is as good as its own numbers.
    const auto& [of_balls, of_boxes, of_oriented] = known.shortfall[set];
    const double parts = sum_of_parts(u);
    if (reach == of_ball) {
        const double terms = dot_of_parts(ball.center, u) + ball.radius * parts;
        return {reach, of_balls * parts + rounding_of(terms)};
    }
    if (reach == of_box) {
        return {reach, of_boxes * parts + rounding_of(dot_of_parts(corner, u))};
    }
    return {reach, of_oriented * parts + rounding_of(support_terms(oriented, u))};
}

glm::dvec3 coordinates(const Approximation& known, int set) {
    const Box& box = known.sure[set];
    return glm::max(glm::abs(box.low), glm::abs(box.high));
}

Approximation approximation(const std::vector<Bounds>& bounds, std::vector<Points> inner) {
    Approximation known;
    known.outer = bounds;
    known.inner = std::move(inner);
    for (const Bounds& of_set : bounds) {
        known.oriented.push_back(as_oriented(of_set.box));
        known.sure.push_back(of_set.box);
        known.shortfall.push_back({0, 0, shortfall_of_oriented(of_set.box)});
    }
    return known;
}

Approximation approximation(const Rifs& rifs, const std::vector<Bounds>& bounds) {
    return approximation(bounds, inner_points(rifs));
}

OrientedBox as_oriented(const Box& box) { return oriented_box(glm::dmat3{1.0}, box.low, box.high); }

double shortfall_of_oriented(const Box& box) {
    const glm::dvec3 far = glm::max(glm::abs(box.low), glm::abs(box.high));
    return rounding_of(std::max({far.x, far.y, far.z}));
}

}  // namespace pxm::host
