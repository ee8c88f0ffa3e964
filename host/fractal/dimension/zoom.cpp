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

double largest_part(const glm::dvec3& x) { return std::max({x.x, x.y, x.z}); }

}  // namespace

ZoomSystem::ZoomSystem(const Rifs& system, const std::vector<Bounds>& bounds)
    : rifs(system), inner(inner_point_of_each(system)) {
    const std::vector<double> weights = natural_weights(rifs);
    for (const Affine& map : rifs.maps) {
        lip.push_back(lipschitz_constant(map));
        const MapKind kind = classify(map);
        similitudes = similitudes && (kind == MapKind::homothety || kind == MapKind::similitude);
    }
    for (std::size_t s = 0; s < bounds.size(); ++s) {
        diameter.push_back(2 * bounds[s].ball.radius);
        center.push_back(bounds[s].ball.center);
        double sum = 0;
        for (const int m : rifs.follow_sets[s].maps) sum += weights[m];
        std::vector<double>& own = choice.emplace_back();
        for (const int m : rifs.follow_sets[s].maps) own.push_back(weights[m] / sum);
    }
    double farthest = 0;
    for (std::size_t m = 0; m < rifs.maps.size(); ++m) {
        seen.push_back(rifs.maps[m].point(center[static_cast<std::size_t>(rifs.follow_of[m])]));
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

bool Zoom::choose_place(double largest, Dice& dice, long& visits) {
    for (long left = most_visits; own_.diameter > largest; ++visits) {
        if (--left < 0) return false;
        const std::vector<int>& maps = system_->rifs.follow_sets[own_.set].maps;
        const std::vector<double>& choice = system_->choice[own_.set];
        double draw = dice.next();
        std::size_t i = 0;
        while (i + 1 < maps.size() && draw >= choice[i]) draw -= choice[i++];
        own_ = child(own_, maps[i], choice[i]);
    }
    place_ = own_.map.point(system_->inner[own_.set]);
    return true;
}

bool Zoom::is_away(const Cell& cell, int map, double reach) const {
    const ZoomSystem& system = *system_;
    const double most = cell.size * system.lip[map] * system.diameter[system.rifs.follow_of[map]];
    const glm::dvec3 away = glm::abs(cell.map.point(system.seen[map]) - place_);
    return largest_part(away) > (reach + most / 2) * (1 + 1e-9) + system.rounding;
}

bool Zoom::gather(double side, double largest, long& visits) {
    const double reach = side + largest;
    std::vector<Cell> open = std::move(around_);
    around_.clear();
    long left = most_visits;
    while (!open.empty()) {
        const Cell cell = open.back();
        open.pop_back();
        ++visits;
        if (--left < 0) return false;
        const glm::dvec3 away = glm::abs(cell.map.point(system_->center[cell.set]) - place_);
        if (largest_part(away) > reach + cell.diameter / 2) continue;
        if (cell.diameter <= largest) {
            if (around_.size() >= most_around) return false;
            around_.push_back(cell);
            continue;
        }
        const std::vector<int>& maps = system_->rifs.follow_sets[cell.set].maps;
        left -= static_cast<long>(maps.size());  // a cell of many maps must not fill the memory
        visits += static_cast<long>(maps.size());
        if (left < 0) return false;
        for (std::size_t i = 0; i < maps.size(); ++i) {
            if (is_away(cell, maps[i], reach)) {  // as it would be when its turn came
                ++visits;
                if (--left < 0) return false;
            } else {
                open.push_back(child(cell, maps[i], system_->choice[cell.set][i]));
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
    for (const Cell& cell : around_) {
        const glm::dvec3 point = cell.map.point(system_->inner[cell.set]);
        for (std::size_t n = 0; n < grids; ++n) {
            const glm::dvec3 in = point - corners[n];
            if (std::min({in.x, in.y, in.z}) >= 0 && largest_part(in) < side)
                measures[n] += cell.measure;
        }
    }
    double sum = 0;
    for (const double measure : measures) sum += 1 / std::max(measure, own_.measure);
    return sum / grids;
}

double Zoom::to(double side, Dice& dice, long& visits) {
    const double largest = side * system_->finest;
    const bool possible = choose_place(largest, dice, visits) && gather(side, largest, visits);
    return possible ? one_over_measure(side, dice) : 0;
}

}  // namespace pxm::host
