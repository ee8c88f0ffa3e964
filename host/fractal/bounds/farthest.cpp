#include "host/fractal/bounds/farthest.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <queue>

namespace pxm::host {

namespace {

/// A word of maps, composed, and how far from the given point what is inside may lie.
struct Cell {
    double upper;
    int set;  // what stands inside
    Affine map;
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
/// v = map.direction(y - center), |d + v|^2 = |d|^2 + 2 d.v + |v|^2, and |v|^2 <= `spread`.
double reach_about(const glm::dvec3& center, double spread, const Affine& map,
                   const glm::dvec3& from, const Approximation& known, int set) {
    const glm::dvec3 d = map.point(center) - from;
    const glm::dvec3 u = d * map.linear;  // d.v = u.(y - center)
    return glm::dot(d, d) + 2 * (volume_support(known, set, u) - glm::dot(u, center)) + spread;
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

double distance_reached(const Affine& map, const Approximation& known, int set,
                        const glm::dvec3& from) {
    const Ball& ball = known.outer[set].ball;
    const OrientedBox& box = known.oriented[set];
    const double of_ball = ball.radius * ball.radius * norm_squared(map.linear);
    const double squared =
        std::min(reach_about(ball.center, of_ball, map, from, known, set),
                 reach_about(box.center, spread_of(box, map), map, from, known, set));
    return std::sqrt(std::max(squared, 0.0));
}

class FarthestSearch {
  public:
    FarthestSearch(const Rifs& rifs, const Approximation& known, const glm::dvec3& from,
                   const FarthestGoal& goal)
        : rifs_(rifs), known_(known), from_(from), goal_(goal) {}

    Reach search(int set) {
        add(std::numeric_limits<double>::infinity(), set, {});
        while (!queue_.empty() && looked_at_ < goal_.budget) {
            const auto [upper, index] = queue_.top();
            if (upper <= goal_.enough || upper <= lower_ + tolerance()) break;
            queue_.pop();
            expand(index);
        }
        double upper = std::max(lower_, upper_of_dropped_);
        if (!queue_.empty()) upper = std::max(upper, queue_.top().first);
        return {upper, lower_, point_, looked_at_};
    }

  private:
    [[nodiscard]] double tolerance() const {
        return std::max(goal_.tolerance, goal_.share * (lower_ - goal_.enough));
    }

    void expand(int index) {
        const Cell cell = cells_[index];
        free_.push_back(index);
        for (const int m : rifs_.follow_sets[cell.set].maps) {
            add(cell.upper, rifs_.follow_of[m], then(rifs_.maps[m], cell.map));
            ++looked_at_;
        }
    }

    void add(double limit, int set, const Affine& map) {
        const double upper = std::min(limit, distance_reached(map, known_, set, from_));
        look_at_points(set, map);
        if (upper <= lower_ + goal_.tolerance || upper <= goal_.enough) {
            upper_of_dropped_ = std::max(upper_of_dropped_, upper);
            return;
        }
        int index = static_cast<int>(cells_.size());
        if (free_.empty()) {
            cells_.push_back({upper, set, map});
        } else {
            index = free_.back();
            free_.pop_back();
            cells_[index] = {upper, set, map};
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
    glm::dvec3 point_{0.0};
    long looked_at_ = 0;
};

}  // namespace

Reach farthest(const Rifs& rifs, const Approximation& known, int set, const glm::dvec3& from,
               const FarthestGoal& goal) {
    return FarthestSearch(rifs, known, from, goal).search(set);
}

}  // namespace pxm::host
