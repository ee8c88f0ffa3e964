#include "host/fractal/bounds.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "host/fractal/enclosing_ball.hpp"
#include "host/fractal/farthest.hpp"
#include "host/fractal/image_box.hpp"
#include "host/fractal/inner_points.hpp"
#include "host/fractal/invariant_ball.hpp"
#include "host/fractal/support.hpp"

namespace pxm::host {

namespace {

constexpr double margin = 1e-9;              // of the size: added to the volumes returned
constexpr double coordinate_margin = 1e-11;  // of the coordinates, for their rounding
constexpr double box_tolerance = 1e-6;       // of the size
constexpr double ball_tolerance = 0.003;  // of the radius: a ball this near to the smallest will do
constexpr double coarse = 1e-2;           // of the size: looser boxes get another round
constexpr long first_budget = 500'000;    // cells looked at for all boxes, and balls, of a round
constexpr long budget_per_edge = 4;       // ... and more where there are many maps
constexpr long declared_budget = 1'000'000;  // ... for one declared volume
constexpr int most_rounds = 3;
constexpr long large_graph = 50'000;  // edges: a system of this size gets one round
constexpr int most_moves = 40;        // of a ball's centre

double largest(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

double coordinate_size(const Bounds& bounds) {
    return largest(glm::max(glm::abs(bounds.box.low), glm::abs(bounds.box.high)));
}

/// The larger of what is sure to be the size of the set and of what rounding can tell.
double size_of(const Points& inner, const Bounds& outer) {
    glm::dvec3 low = inner.front();
    glm::dvec3 high = inner.front();
    for (const glm::dvec3& point : inner) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    return std::max({largest(high - low), margin * outer.ball.radius,
                     coordinate_margin * coordinate_size(outer)});
}

/// Shrinks the box of one set to its reach in six directions. Returns how loose it may still be,
/// as a share of the set's size.
double tighten_box(const Rifs& rifs, Approximation& known, int set, long budget) {
    const double size = size_of(known.inner[set], known.outer[set]);
    const double tolerance = box_tolerance * size;
    double slack = 0;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double sign : {-1.0, 1.0}) {
            glm::dvec3 u{0.0};
            u[axis] = sign;
            const Reach found = reach(rifs, known, set, u, tolerance, budget / 6);
            Box& box = known.outer[set].box;
            if (sign < 0) {
                box.low[axis] = std::max(box.low[axis], -found.upper);
            } else {
                box.high[axis] = std::min(box.high[axis], found.upper);
            }
            known.inner[set].push_back(found.point);
            slack = std::max(slack, (found.upper - found.lower) / size);
        }
    }
    return slack;
}

/// Shrinks the ball of one set: the smallest ball of some of its points is moved until no point of
/// the set lies far outside. Returns how much larger than the smallest the ball may be, as a share.
double tighten_ball(const Rifs& rifs, Approximation& known, int set, long budget) {
    Ball& best = known.outer[set].ball;
    Points points = known.inner[set];
    double needed = 0;  // radius of the smallest ball of some points: the set's is no smaller
    for (int move = 0; move < most_moves && budget > 0; ++move) {
        const Ball inner = enclosing_ball(points);
        needed = std::max(needed, inner.radius);
        const double enough = inner.radius * (1 + ball_tolerance);
        const FarthestGoal goal{enough, inner.radius * ball_tolerance / 4, 0.25, budget / 2};
        const Reach found = farthest(rifs, known, set, inner.center, goal);
        budget -= std::max(found.cells, 1L);
        if (found.upper < best.radius) best = {inner.center, found.upper};
        if (found.upper <= enough || found.lower <= inner.radius * (1 + ball_tolerance / 4)) break;
        points.push_back(found.point);
    }
    if (best.radius <= needed) return 0;
    return needed > 0 ? best.radius / needed - 1 : std::numeric_limits<double>::infinity();
}

void add_margin(Bounds& bounds) {
    const double rounding = coordinate_margin * coordinate_size(bounds);
    bounds.ball.radius += margin * bounds.ball.radius + rounding;
    const glm::dvec3 more = margin * (bounds.box.high - bounds.box.low) + glm::dvec3{rounding};
    bounds.box.low -= more;
    bounds.box.high += more;
}

/// One set at a time, those farthest down first would be best; any order is correct.
double tighten(const Rifs& rifs, Approximation& known) {
    const long sets = static_cast<long>(known.outer.size());
    long edges = 0;
    for (const FollowSet& set : rifs.follow_sets) edges += static_cast<long>(set.maps.size());
    const long budget = (first_budget + budget_per_edge * edges) / sets;
    double slack = 0;
    for (int s = 0; s < sets; ++s) {
        slack = std::max(slack, tighten_box(rifs, known, s, budget));
    }
    shrink_boxes(rifs, known.outer);
    for (int s = 0; s < sets; ++s) {
        known.outer[s].ball_slack = tighten_ball(rifs, known, s, budget);
    }
    return slack;
}

}  // namespace

std::vector<Bounds> bound(const Rifs& rifs, const Contraction& contraction) {
    Approximation known;
    known.inner = inner_points(rifs);
    known.outer = invariant_volumes(rifs, contraction, known.inner);
    shrink_boxes(rifs, known.outer);
    // A second round starts from the first one's volumes and gets farther with the same budget.
    for (int round = 0; round < most_rounds; ++round) {
        if (tighten(rifs, known) <= coarse) break;
    }
    for (Bounds& bounds : known.outer) add_margin(bounds);
    return known.outer;
}

double short_by(const Rifs& rifs, const std::vector<Bounds>& bounds, int set,
                const SphereVolume& volume) {
    const Approximation known{bounds, inner_points(rifs)};
    const double rounding =
        margin * bounds[set].ball.radius + coordinate_margin * coordinate_size(bounds[set]);
    const FarthestGoal goal{volume.radius + rounding, rounding, 1e-3, declared_budget};
    const double over = farthest(rifs, known, set, volume.center, goal).upper - volume.radius;
    return over <= rounding ? std::min(over, 0.0) : over;
}

double short_by(const Rifs& rifs, const std::vector<Bounds>& bounds, int set,
                const BoxVolume& volume) {
    const Approximation known{bounds, inner_points(rifs)};
    const double rounding =
        margin * bounds[set].ball.radius + coordinate_margin * coordinate_size(bounds[set]);
    double over = -std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 u{0.0};
        u[axis] = 1;
        const double high = reach(rifs, known, set, u, rounding, declared_budget).upper;
        const double low = reach(rifs, known, set, -u, rounding, declared_budget).upper;
        over = std::max({over, high - volume.high[axis], low + volume.low[axis]});
    }
    return over <= rounding ? std::min(over, 0.0) : over;
}

}  // namespace pxm::host
