#include "host/fractal/bounds/farthest.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <queue>

#include "host/process/give_up.hpp"

namespace pxm::host {

namespace {

/// A word of maps, composed, and how far from the given point what is inside may lie.
struct Cell {
    double upper;
    double sure;  // ... rounding or not
    int set;      // what stands inside
    Affine map;
    double error = 0;  // by how much `map` may be off, for points of the set
};

/// An upper bound of the squared norm of a matrix, exact for uniform scales.
double norm_squared(const glm::dmat3& m) {
    double frobenius = 0;
    double columns = 0;
    glm::dvec3 rows{0.0};
    for (int i = 0; i < 3; ++i) {
        frobenius += glm::dot(m[i], m[i]);
        const glm::dvec3 size = glm::abs(m[i]);
        columns = std::max(columns, size.x + size.y + size.z);
        rows += size;
    }
    return std::min(frobenius, columns * std::max({rows.x, rows.y, rows.z}));
}

/// The squared distance that map(E) reaches from a point d away from map(center): with
/// v = map.direction(y - center), |d + v|^2 = |d|^2 + 2 d.v + |v|^2, and |v|^2 <= `spread`. What it
/// may be short by for rounding: that of d apart, which counts once as a distance, and with v up to
/// `beside` longer than sqrt(spread) for some points.
Rounded reach_about(const glm::dvec3& center, double spread, double beside, const Affine& map,
                    const glm::dvec3& from, const Approximation& known, int set) {
    const glm::dvec3 d = map.point(center) - from;
    const glm::dvec3 u = d * map.linear;  // d.v = u.(y - center)
    const Rounded reach = volume_support(known, set, u);
    const double value = glm::dot(d, d) + 2 * (reach.value - glm::dot(u, center)) + spread;
    const glm::dvec3 places = coordinates(known, set) + glm::abs(center);
    const double terms = glm::dot(d, d) + std::abs(reach.value) + spread +
                         dot_of_parts(d, terms_of(map.linear, places, glm::dvec3{0.0}));
    return {value,
            2 * (reach.rounding + rounding_of(terms)) + beside * (2 * std::sqrt(spread) + beside)};
}

/// |v|^2 for y in a box about its centre: at most the sum of |g_i . g_j|, g the half axes' images.
double spread_of(const OrientedBox& box, const Affine& map) {
    double spread = 0;
    std::array<glm::dvec3, 3> g;
    for (int i = 0; i < 3; ++i) {
        g[i] = map.direction(box.half[i]);
        spread += glm::dot(g[i], g[i]);
        for (int j = 0; j < i; ++j) spread += 2 * std::abs(glm::dot(g[i], g[j]));
    }
    return spread;
}

/// What rounding may take from spread_of(), as a length.
double rounding_of_spread(const OrientedBox& box, const Affine& map) {
    double terms = 0;
    for (const glm::dvec3& half : box.half) {
        terms += sum_of_parts(terms_of(map.linear, half, glm::dvec3{0.0}));
    }
    return 2 * rounding_of(terms);
}

/// Where a point of the set may lie at most, and what rounding may have taken from that.
Rounded distance_reached(const Affine& map, const Approximation& known, int set,
                         const glm::dvec3& from) {
    const Ball& ball = known.outer[set].ball;
    const OrientedBox& box = known.oriented[set];
    const double norm = norm_squared(map.linear);
    const double of_ball = ball.radius * ball.radius * norm;
    // sqrt 3 < 2: what sticks out of a volume along each axis is less than twice that long.
    const double longer = 2 * std::sqrt(norm);
    const Shortfall& shortfall = known.shortfall[set];
    const double beside_ball = longer * (shortfall.ball + rounding_of(ball.radius));
    const double beside_box = longer * shortfall.oriented + rounding_of_spread(box, map);
    const Rounded about_ball =
        reach_about(ball.center, of_ball, beside_ball, map, from, known, set);
    const Rounded about_box =
        reach_about(box.center, spread_of(box, map), beside_box, map, from, known, set);
    const bool ball_is_less = !(about_box.value < about_ball.value);
    const auto& [squared, rounding] = ball_is_less ? about_ball : about_box;
    const double distance = std::sqrt(std::max(squared, 0.0));
    const glm::dvec3 center = ball_is_less ? ball.center : box.center;
    const double of_d =
        sum_of_parts(terms_of(map.linear, center, glm::abs(map.translation) + glm::abs(from)));
    const double sure = std::sqrt(std::max(squared, 0.0) + rounding);
    return {distance, above(sure - distance) + rounding_of(sure + of_d)};
}

class FarthestSearch {
  public:
    FarthestSearch(const Rifs& rifs, const Approximation& known, const glm::dvec3& from,
                   const FarthestGoal& goal)
        : rifs_(rifs), known_(known), from_(from), goal_(goal) {}

    Reach search(int set) {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        add({infinity, infinity, set, {}, 0});
        while (!queue_.empty() && looked_at_ < goal_.budget) {
            give_up_if_asked();
            const auto [upper, index] = queue_.top();
            if (upper <= goal_.enough || upper <= lower_ + tolerance()) break;
            queue_.pop();
            expand(index);
        }
        double upper = std::max(lower_, upper_of_dropped_);
        if (!queue_.empty()) upper = std::max(upper, queue_.top().first);
        double sure = sure_of_dropped_;
        for (; !queue_.empty(); queue_.pop()) {
            sure = std::max(sure, cells_[queue_.top().second].sure);
        }
        return {upper, sure <= upper ? 0 : above(sure - upper), lower_, point_, looked_at_};
    }

  private:
    [[nodiscard]] double tolerance() const {
        return std::max(goal_.tolerance, goal_.share * (lower_ - goal_.enough));
    }

    void expand(int index) {
        const Cell cell = cells_[index];
        free_.push_back(index);
        for (const int m : rifs_.follow_sets[cell.set].maps) {
            add(inside(cell, m));
            ++looked_at_;
        }
    }

    /// What stands in one more map within a cell. Composing the maps anew is off by a few roundings
    /// of the terms for any point of it; what the cell was off by stays as it was.
    [[nodiscard]] Cell inside(const Cell& cell, int m) const {
        const Affine& map = rifs_.maps[m];
        Cell result{cell.upper, cell.sure, rifs_.follow_of[m], then(map, cell.map), cell.error};
        const glm::dvec3 places =
            terms_of(map.linear, coordinates(known_, result.set), map.translation);
        result.error +=
            rounding_of(sum_of_parts(terms_of(cell.map.linear, places, cell.map.translation)));
        return result;
    }

    /// `upper` and `sure` of the cell are its parent's.
    void add(Cell cell) {
        const Rounded reached = distance_reached(cell.map, known_, cell.set, from_);
        const double upper = std::min(cell.upper, reached.value);
        const double sure = above(reached.at_most() + cell.error);
        if (sure < cell.sure) cell.sure = sure;
        cell.upper = upper;
        look_at_points(cell.set, cell.map);
        if (upper <= lower_ + goal_.tolerance || upper <= goal_.enough) {
            upper_of_dropped_ = std::max(upper_of_dropped_, upper);
            sure_of_dropped_ = std::max(sure_of_dropped_, cell.sure);
            return;
        }
        int index = static_cast<int>(cells_.size());
        if (free_.empty()) {
            cells_.push_back(cell);
        } else {
            index = free_.back();
            free_.pop_back();
            cells_[index] = cell;
        }
        queue_.emplace(upper, index);
    }

    /// The point of the cell that lies farthest in the cell's own direction from the given point.
    void look_at_points(int set, const Affine& map) {
        const Points& points = known_.inner[set];
        const glm::dvec3 outward = map.point(points.front()) - from_;
        const glm::dvec3 point = map.point(extreme(points, outward * map.linear));
        const double distance = glm::distance(point, from_);
        if (!(distance > lower_)) return;
        lower_ = distance;
        point_ = point;
    }

    const Rifs& rifs_;
    const Approximation& known_;
    glm::dvec3 from_;
    FarthestGoal goal_;
    std::vector<Cell> cells_;
    std::vector<int> free_;  // places in cells_ to use again
    std::priority_queue<std::pair<double, int>> queue_;
    double lower_ = -1;
    double upper_of_dropped_ = 0;
    double sure_of_dropped_ = 0;
    glm::dvec3 point_{0.0};
    long looked_at_ = 0;
};

}  // namespace

Reach farthest(const Rifs& rifs, const Approximation& known, int set, const glm::dvec3& from,
               const FarthestGoal& goal) {
    return FarthestSearch(rifs, known, from, goal).search(set);
}

}  // namespace pxm::host
