#include "host/fractal/bounds/support_grid.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "host/process/give_up.hpp"

namespace pxm::host {

// Grid points (x, y, z) are integers with |x|+|y|+|z| = n. Both halves are stored as full squares
// of (2n+1) x (2n+1) places, though only the diamond |x|+|y| <= n is used: the index is then a
// product.

DirectionGrid::DirectionGrid(int steps) : steps_(steps) {
    const int side = 2 * steps + 1;
    points_.resize(static_cast<std::size_t>(2 * side * side), glm::dvec3{0.0});
    for (int x = -steps; x <= steps; ++x) {
        for (int y = -steps; y <= steps; ++y) {
            const int z = steps - std::abs(x) - std::abs(y);
            if (z < 0) continue;
            points_[index(x, y, 1)] = {x, y, z};
            if (z > 0) points_[index(x, y, -1)] = {x, y, -z};
        }
    }
}

int DirectionGrid::index(int x, int y, int sign_z) const {
    const int side = 2 * steps_ + 1;
    return ((sign_z < 0 ? side : 0) + x + steps_) * side + y + steps_;
}

DirectionGrid::Place DirectionGrid::locate(const glm::dvec3& u) const {
    const double length = std::abs(u.x) + std::abs(u.y) + std::abs(u.z);
    const double scale = steps_ / length;
    const int sign_x = u.x < 0 ? -1 : 1;
    const int sign_y = u.y < 0 ? -1 : 1;
    const int sign_z = u.z < 0 ? -1 : 1;
    const double a = std::abs(u.x) * scale;
    const double b = std::abs(u.y) * scale;
    // Also for a direction that is not finite, of a system that double cannot hold.
    const auto at_most = [](double x, int most) { return x < most ? static_cast<int>(x) : most; };
    const int i = at_most(a, steps_ - 1);
    const int j = at_most(b, steps_ - 1 - i);
    const auto corner = [&](int x, int y) {
        const bool on_rim = x + y == steps_;  // z = 0: stored in the upper half only
        return index(sign_x * x, sign_y * y, on_rim ? 1 : sign_z);
    };
    // Clamped: rounding may leave a weight below zero, which would not be a bound.
    const double p = std::clamp(a - i, 0.0, 1.0);
    const double q = std::clamp(b - j, 0.0, 1.0);
    const double back = 1 / scale;
    if (p + q <= 1 || i + j + 2 > steps_) {
        return {{corner(i, j), corner(i + 1, j), corner(i, j + 1)},
                {std::max(1 - p - q, 0.0) * back, p * back, q * back}};
    }
    return {{corner(i + 1, j + 1), corner(i + 1, j), corner(i, j + 1)},
            {(p + q - 1) * back, (1 - q) * back, (1 - p) * back}};
}

double DirectionGrid::bulge() const {
    // On the triangle's plane through the unit corners the sum of weights is 1: the plane's
    // distance from the origin is what a unit vector can fall short by. The eight faces are alike.
    double nearest = 1;
    const auto unit = [&](int x, int y) { return glm::normalize(points_[index(x, y, 1)]); };
    const auto measure = [&](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
        const glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a));
        nearest = std::min(nearest, std::abs(glm::dot(normal, a)));
    };
    for (int x = 0; x < steps_; ++x) {
        for (int y = 0; x + y < steps_; ++y) {
            measure(unit(x, y), unit(x + 1, y), unit(x, y + 1));
            if (x + y + 2 > steps_) continue;
            measure(unit(x + 1, y + 1), unit(x + 1, y), unit(x, y + 1));
        }
    }
    return 1 / nearest;
}

SupportGrid::SupportGrid(int steps, std::vector<glm::dvec3> centers, std::vector<double> extents)
    : directions_(steps),
      center_(std::move(centers)),
      extent_(std::move(extents)),
      value_(center_.size(), std::vector<Rounded>(static_cast<std::size_t>(directions_.size()))) {}

double SupportGrid::support(int set, const glm::dvec3& u) const {
    return glm::dot(u, center_[set]) + from_center(set, u);
}

double SupportGrid::rounding(int set, const glm::dvec3& u) const {
    return rounding_of(dot_of_parts(u, center_[set])) + rounding_from_center(set, u);
}

double SupportGrid::from_center(int set, const glm::dvec3& u) const {
    if (!(std::abs(u.x) + std::abs(u.y) + std::abs(u.z) > std::numeric_limits<double>::min())) {
        return 0;
    }
    const auto [corner, weight] = directions_.locate(u);
    const std::vector<Rounded>& value = value_[set];
    return weight[0] * value[corner[0]].value + weight[1] * value[corner[1]].value +
           weight[2] * value[corner[2]].value;
}

/// The three weights are off by at most 11 u of |u|, u = 2^-53, and with them each part of the
/// direction that they stand for by 33 u steps |u|; how far the set reaches from its centre along
/// each of three axes says what that is worth.
double SupportGrid::rounding_from_center(int set, const glm::dvec3& u) const {
    const double parts = sum_of_parts(u);
    if (!(parts > std::numeric_limits<double>::min())) return 2 * parts * extent_[set];
    const auto [corner, weight] = directions_.locate(u);
    double rounding = rounding_of(8 * directions_.steps() * parts * extent_[set]);
    for (std::size_t i = 0; i < corner.size(); ++i) {
        const Rounded& value = value_[set][corner[i]];
        rounding += weight[i] * value.rounding + rounding_of(weight[i] * std::abs(value.value));
    }
    return rounding;
}

double SupportGrid::iterate(const Rifs& rifs) {
    double change = 0;
    for (std::size_t s = 0; s < value_.size(); ++s) {
        double moved = 0;
        double largest = 0;
        for (int i = 0; i < directions_.size(); ++i) {
            const glm::dvec3& u = directions_.point(i);
            if (!directions_.is_point(i)) continue;
            give_up_if_asked();
            double reach = -std::numeric_limits<double>::infinity();
            for (const int m : rifs.follow_sets[s].maps) {
                reach = std::max(reach, reach_of_map(rifs, m, u));
            }
            reach -= glm::dot(u, center_[s]);
            Rounded& value = value_[s][i];
            largest = std::max(largest, value.value);
            moved = std::max(moved, value.value - reach);
            if (!(reach < value.value)) continue;
            value = {reach, 0};
            for (const int m : rifs.follow_sets[s].maps) {
                value.rounding = std::max(value.rounding, rounding_of_map(rifs, m, u));
            }
            value.rounding += rounding_of(std::abs(reach) + dot_of_parts(u, center_[s]));
        }
        if (largest > 0) change = std::max(change, moved / largest);
    }
    return change;
}

double SupportGrid::reach_of_map(const Rifs& rifs, int map, const glm::dvec3& u) const {
    const int inside = rifs.follow_of[map];
    return glm::dot(u, rifs.maps[map].point(center_[inside])) +
           from_center(inside, u * rifs.maps[map].linear);
}

/// u . m(x) = u . m(c) + (u T) . (x - c), of a point x of the set inside with the centre c.
double SupportGrid::rounding_of_map(const Rifs& rifs, int map, const glm::dvec3& u) const {
    const int inside = rifs.follow_of[map];
    const auto& [linear, translation] = rifs.maps[map];
    const glm::dvec3 of_center = terms_of(linear, center_[inside], translation);
    const glm::dvec3 of_extent = terms_of(linear, glm::dvec3{extent_[inside]}, glm::dvec3{0.0});
    return rounding_of(dot_of_parts(u, of_center + of_extent)) +
           rounding_from_center(inside, u * linear);
}

int SupportGrid::best_map(const Rifs& rifs, int set, const glm::dvec3& u) const {
    const std::vector<int>& maps = rifs.follow_sets[set].maps;
    int best = maps.front();
    double best_reach = -std::numeric_limits<double>::infinity();
    for (const int m : maps) {
        const double reach = reach_of_map(rifs, m, u);
        if (reach <= best_reach) continue;
        best_reach = reach;
        best = m;
    }
    return best;
}

}  // namespace pxm::host
