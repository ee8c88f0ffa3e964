#include "host/fractal/farthest.hpp"

#include <algorithm>
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

/// An upper bound of the squared norm of a matrix, exact for uniform scales and for boxes' axes.
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

/// |d + v|^2 = |d|^2 + 2 d.v + |v|^2 for v = map.direction(y), y in the ball of radius r about 0.
double reach_of_ball(const Affine& map, const Ball& ball, const glm::dvec3& from) {
    const glm::dvec3 d = map.point(ball.center) - from;
    const double turned = glm::length(d * map.linear);
    return glm::dot(d, d) + ball.radius * (2 * turned + ball.radius * norm_squared(map.linear));
}

/// The same for y in a box: |v|^2 is at most the sum of |g_i . g_j|, g the images of the half axes.
double reach_of_box(const Affine& map, const Box& box, const glm::dvec3& from) {
    const glm::dvec3 half = (box.high - box.low) / 2.0;
    const glm::dvec3 d = map.point((box.low + box.high) / 2.0) - from;
    glm::dmat3 g = map.linear;
    double reach = glm::dot(d, d);
    for (int i = 0; i < 3; ++i) {
        g[i] *= half[i];
        reach += 2 * std::abs(glm::dot(d, g[i])) + glm::dot(g[i], g[i]);
        for (int j = 0; j < i; ++j) reach += 2 * std::abs(glm::dot(g[i], g[j]));
    }
    return reach;
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
        const Bounds& outer = known_.outer[set];
        const double reach = std::sqrt(
            std::min(reach_of_ball(map, outer.ball, from_), reach_of_box(map, outer.box, from_)));
        const double upper = std::min(limit, reach);
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
