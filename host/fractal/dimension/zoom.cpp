#include "host/fractal/dimension/zoom.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "host/fractal/bounds/inner_points.hpp"
#include "host/fractal/dimension/default_weights.hpp"
#include "host/math/lipschitz.hpp"

namespace pxm::host {

namespace {

constexpr double cells_a_side = 2;     // cells are at most a side over this
constexpr double cells_a_side_3d = 1;  // where that would be too many
constexpr std::size_t grids = 4;       // places of the grid that are tried at each scale
constexpr std::size_t most_around = 5000;
constexpr long most_visits = 400'000;  // of one step

/// At least the largest singular value, and at most sqrt 3 times it.
double size_of(const glm::dmat3& linear) {
    return std::sqrt(glm::dot(linear[0], linear[0]) + glm::dot(linear[1], linear[1]) +
                     glm::dot(linear[2], linear[2]));
}

/// Half the sides of the box around the image of a box.
glm::dvec3 half_of_image(const glm::dmat3& linear, const glm::dvec3& half) {
    return glm::abs(linear[0]) * half.x + glm::abs(linear[1]) * half.y +
           glm::abs(linear[2]) * half.z;
}

double largest_part(const glm::dvec3& x) { return std::max({x.x, x.y, x.z}); }

}  // namespace

ZoomSystem::ZoomSystem(const Rifs& system, const std::vector<Bounds>& bounds)
    : rifs(system), inner(inner_point_of_each(system)), hulls(affine_hulls(system)) {
    const std::vector<double> weights = natural_weights(rifs);
    for (const Affine& map : rifs.maps) {
        lip.push_back(lipschitz_constant(map));
        const MapKind kind = classify(map);
        similitudes = similitudes && (kind == MapKind::homothety || kind == MapKind::similitude);
    }
    for (std::size_t s = 0; s < bounds.size(); ++s) {
        diameter.push_back(2 * bounds[s].ball.radius);
        center.push_back(bounds[s].ball.center);
        middle.push_back((bounds[s].box.low + bounds[s].box.high) / 2.0);
        half.push_back((bounds[s].box.high - bounds[s].box.low) / 2.0);
        double sum = 0;
        for (const int m : rifs.follow_sets[s].maps) sum += weights[m];
        std::vector<double>& own = choice.emplace_back();
        for (const int m : rifs.follow_sets[s].maps) own.push_back(weights[m] / sum);
    }
    if (!similitudes) layers = layers_of(rifs, bounds);
    double farthest = 0;
    for (std::size_t m = 0; m < rifs.maps.size(); ++m) {
        seen.push_back(rifs.maps[m].point(center[static_cast<std::size_t>(rifs.follow_of[m])]));
        const auto set = static_cast<std::size_t>(rifs.follow_of[m]);
        seen_middle.push_back(rifs.maps[m].point(middle[set]));
        seen_half.push_back(half_of_image(rifs.maps[m].linear, half[set]));
        farthest = std::max(farthest, glm::length(seen.back()));
    }
    for (std::size_t s = 0; s < bounds.size(); ++s)
        farthest = std::max(farthest, glm::length(center[s]) + diameter[s]);
    rounding = 1e-13 * farthest;
    const glm::dvec3 extent = bounds[rifs.start].box.high - bounds[rifs.start].box.low;
    const double thin = std::min({extent.x, extent.y, extent.z});
    finest = 1 / (thin > 1e-3 * diameter[rifs.start] ? cells_a_side_3d : cells_a_side);
}

Zoom::Zoom(const ZoomSystem& system) : system_(&system) {
    own_ = {Affine{}, system.rifs.start, 1, system.diameter[system.rifs.start], 1};
    around_ = {own_};
}

Zoom::Cell Zoom::child(const Cell& cell, int map, double probability) const {
    const ZoomSystem& system = *system_;
    const int set = system.rifs.follow_of[map];
    Cell next{then(system.rifs.maps[map], cell.map), set, 0, 0, cell.measure * probability};
    next.size = system.similitudes ? cell.size * system.lip[map] : size_of(next.map.linear);
    next.diameter = next.size * system.diameter[set];
    return next;
}

bool Zoom::is_thick(const Cell& cell, double largest) const {
    if (!system_->layers) return true;
    const int axis = system_->layers->axes.back();
    return 2 * std::abs(cell.map.linear[axis][axis]) * system_->half[0][axis] > largest;
}

const std::vector<double>& Zoom::choice(const Cell& cell, double largest) const {
    const auto& layers = system_->layers;
    if (!layers) return system_->choice[static_cast<std::size_t>(cell.set)];
    std::size_t level = layers->axes.size() - 1;
    for (; level > 0; --level) {
        const int axis = layers->axes[level];
        if (2 * std::abs(cell.map.linear[axis][axis]) * system_->half[0][axis] > largest) break;
    }
    return layers->choice[level];
}

Zoom::Cell Zoom::drawn(const Cell& cell, double largest, Dice& dice) const {
    const std::vector<int>& maps = system_->rifs.follow_sets[cell.set].maps;
    const std::vector<double>& shares = choice(cell, largest);
    double draw = dice.next();
    std::size_t i = 0;
    while (i + 1 < maps.size() && draw >= shares[i]) draw -= shares[i++];
    return child(cell, maps[i], shares[i]);
}

bool Zoom::choose_place(double largest, Dice& dice, long& visits) {
    long left = most_visits;
    for (; own_.diameter > largest && is_thick(own_, largest); ++visits) {
        if (--left < 0) return false;
        own_ = drawn(own_, largest, dice);
    }
    for (last_ = own_; last_.diameter > largest; ++visits) {
        if (--left < 0) return false;
        last_ = drawn(last_, largest, dice);
    }
    place_ = last_.map.point(system_->inner[last_.set]);
    return true;
}

double Zoom::thickness(const Cell& cell) const {
    const AffineHull& hull = system_->hulls[static_cast<std::size_t>(cell.set)];
    const double diameter = system_->diameter[static_cast<std::size_t>(cell.set)];
    const glm::dvec3 a = cell.map.linear * hull.axes[0];
    const glm::dvec3 b = cell.map.linear * hull.axes[1];
    if (hull.dimension < 2) return glm::length(a) * diameter;
    // The least singular value is the volume over the product of the others.
    const double squares = glm::dot(a, a) + glm::dot(b, b);
    const glm::dvec3 area = glm::cross(a, b);
    if (squares == 0) return 0;
    if (hull.dimension == 2) return glm::length(area) / std::sqrt(squares) * diameter;
    const glm::dvec3 c = cell.map.linear * hull.axes[2];
    return 2 * std::abs(glm::dot(area, c)) / (squares + glm::dot(c, c)) * diameter;
}

bool Zoom::is_beside(const Cell& cell, const glm::dvec3& middle, const glm::dvec3& half,
                     const Window& window) const {
    const glm::dvec3 away = glm::abs(cell.map.point(middle) - window.middle);
    const glm::dvec3 least = half_of_image(cell.map.linear, half) * (1 + 1e-9) + window.half;
    for (int i = 0; i < 3; ++i)
        if (away[i] > least[i] + system_->rounding) return true;
    return false;
}

bool Zoom::is_away(const Cell& cell, const Window& window) const {
    const ZoomSystem& system = *system_;
    const auto set = static_cast<std::size_t>(cell.set);
    if (!system.similitudes) return is_beside(cell, system.middle[set], system.half[set], window);
    const glm::dvec3 away = glm::abs(cell.map.point(system.center[set]) - window.middle);
    return largest_part(away) > window.half.x + cell.diameter / 2;
}

bool Zoom::is_away(const Cell& cell, int map, const Window& window) const {
    const ZoomSystem& system = *system_;
    const auto m = static_cast<std::size_t>(map);
    if (!system.similitudes)
        return is_beside(cell, system.seen_middle[m], system.seen_half[m], window);
    const double most = cell.size * system.lip[m] * system.diameter[system.rifs.follow_of[m]];
    const glm::dvec3 away = glm::abs(cell.map.point(system.seen[m]) - window.middle);
    return largest_part(away) > (window.half.x + most / 2) * (1 + 1e-9) + system.rounding;
}

bool Zoom::is_small(const Cell& cell, double largest) const {
    if (cell.diameter <= largest) return true;
    if (system_->similitudes) return false;
    return system_->layers ? !is_thick(cell, largest) : thickness(cell) <= largest;
}

bool Zoom::gather(double side, double largest, long& visits) {
    Window window{place_, glm::dvec3{side + largest}};
    if (system_->layers) {  // the next place is anywhere in the same cell
        window.middle = own_.map.point(system_->middle[0]);
        window.half += half_of_image(own_.map.linear, system_->half[0]);
    }
    std::vector<Cell> open = std::move(around_);
    around_.clear();
    long left = most_visits;
    while (!open.empty()) {
        const Cell cell = open.back();
        open.pop_back();
        ++visits;
        if (--left < 0) return false;
        if (is_away(cell, window)) continue;
        if (is_small(cell, largest)) {
            if (around_.size() >= most_around) return false;
            around_.push_back(cell);
            continue;
        }
        const std::vector<int>& maps = system_->rifs.follow_sets[cell.set].maps;
        left -= static_cast<long>(maps.size());  // a cell of many maps must not fill the memory
        visits += static_cast<long>(maps.size());
        if (left < 0) return false;
        const std::vector<double>& shares = choice(cell, largest);
        for (std::size_t i = 0; i < maps.size(); ++i) {
            if (is_away(cell, maps[i], window)) {  // as it would be when its turn came
                ++visits;
                if (--left < 0) return false;
            } else {
                open.push_back(child(cell, maps[i], shares[i]));
            }
        }
    }
    return true;
}

double Zoom::one_over_measure(double side, Dice& dice) const {
    std::array<glm::dvec3, grids> corners;
    for (glm::dvec3& corner : corners)
        corner = place_ - side * glm::dvec3{dice.next(), dice.next(), dice.next()};
    std::array<double, grids> measures{};
    for (const Cell& cell : system_->similitudes ? around_ : short_) {
        const glm::dvec3 point = cell.map.point(system_->inner[cell.set]);
        for (std::size_t n = 0; n < grids; ++n) {
            const glm::dvec3 in = point - corners[n];
            if (std::min({in.x, in.y, in.z}) >= 0 && largest_part(in) < side)
                measures[n] += cell.measure;
        }
    }
    double sum = 0;
    for (const double measure : measures) sum += 1 / std::max(measure, last_.measure);
    return sum / grids;
}

double Zoom::to(double side, Dice& dice, long& visits) {
    const double largest = side * system_->finest;
    const bool possible = choose_place(largest, dice, visits) && gather(side, largest, visits) &&
                          (system_->similitudes || divide_thin(side, largest, visits));
    return possible ? one_over_measure(side, dice) : 0;
}

}  // namespace pxm::host
