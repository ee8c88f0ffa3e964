#include "host/fractal/bounds/bounds.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "host/fractal/bounds/enclosing_ball.hpp"
#include "host/fractal/bounds/farthest.hpp"
#include "host/fractal/bounds/grid_bounds.hpp"
#include "host/fractal/bounds/image_box.hpp"
#include "host/fractal/bounds/inner_points.hpp"
#include "host/fractal/bounds/invariant_ball.hpp"
#include "host/fractal/bounds/support.hpp"

namespace pxm::host {

namespace {

// Added to the volumes returned, so that they are the same on computers that round otherwise; what
// rounding took is known, and added instead where it is more.
constexpr double margin = 1e-9;              // of the size
constexpr double coordinate_margin = 1e-11;  // of the coordinates
constexpr double box_tolerance = 1e-6;       // of the size
constexpr double oriented_tolerance = 1e-4;  // of the size
constexpr double ball_tolerance = 0.003;  // of the radius: a ball this near to the smallest will do
constexpr double coarse = 1e-2;           // of the size: looser boxes get another round
constexpr long first_budget = 200'000;    // cells looked at for all boxes, and balls, of a round
constexpr long budget_per_edge = 4;       // ... and more where there are many maps
constexpr int most_rounds = 3;
constexpr long large_graph = 50'000;  // edges: a system of this size gets one round
constexpr int most_moves = 40;        // of a ball's centre
constexpr long cells_per_move = 100;  // that a move costs as much as, besides its own

double largest(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

double volume(const glm::dvec3& sides) { return sides.x * sides.y * sides.z; }

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
    Box& sure = known.sure[set];
    for (int axis = 0; axis < 3; ++axis) {
        for (const double sign : {-1.0, 1.0}) {
            glm::dvec3 u{0.0};
            u[axis] = sign;
            const Reach found = reach(rifs, known, set, u, tolerance, budget / 6);
            Box& box = known.outer[set].box;
            if (sign < 0) {
                box.low[axis] = std::max(box.low[axis], -found.upper);
                sure.low[axis] = std::max(sure.low[axis], -found.at_most());
            } else {
                box.high[axis] = std::min(box.high[axis], found.upper);
                sure.high[axis] = std::min(sure.high[axis], found.at_most());
            }
            known.shortfall[set].box = shortfall_of_box(box, sure);
            known.inner[set].push_back(found.point);
            slack = std::max(slack, (found.upper - found.lower) / size);
        }
    }
    return slack;
}

/// The box along the principal axes of the set's points, if it is smaller than the box along the
/// coordinate axes: a descent is as quick for a set askew as for one that is not.
void tighten_oriented_box(const Rifs& rifs, Approximation& known, int set, long budget) {
    const double tolerance = oriented_tolerance * size_of(known.inner[set], known.outer[set]);
    const glm::dmat3 axes = principal_axes(known.inner[set]);
    glm::dvec3 low;
    glm::dvec3 high;
    double rounding = 0;
    for (int i = 0; i < 3; ++i) {
        const Reach up = reach(rifs, known, set, axes[i], tolerance, budget / 6);
        const Reach down = reach(rifs, known, set, -axes[i], tolerance, budget / 6);
        high[i] = up.upper;
        low[i] = -down.upper;
        rounding = std::max({rounding, up.rounding, down.rounding});
    }
    const Box& box = known.outer[set].box;
    const bool smaller = volume(high - low) < volume(box.high - box.low);
    known.oriented[set] = smaller ? oriented_box(axes, low, high) : as_oriented(box);
    Shortfall& shortfall = known.shortfall[set];
    shortfall.oriented =
        smaller ? 3 * rounding + shortfall_along(axes, low, high, coordinates(known, set))
                : shortfall.box + shortfall_of_oriented(box);
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
        budget -= found.cells + cells_per_move;
        if (found.upper < best.radius) {
            best = {inner.center, found.upper};
            known.shortfall[set].ball = found.rounding;
        }
        if (found.upper <= enough || found.lower <= inner.radius * (1 + ball_tolerance / 4)) break;
        points.push_back(found.point);
    }
    if (best.radius <= needed) return 0;
    return needed > 0 ? best.radius / needed - 1 : std::numeric_limits<double>::infinity();
}

/// The margin, and where it is too small for what rounding took, more; with room for the rounding
/// of a few steps, in other coordinates or as an oriented box.
void add_margin(Bounds& bounds, const Box& sure, double shortfall_of_ball) {
    const double of_places = coordinate_margin * coordinate_size(bounds);
    const double room = rounding_of(coordinate_size(bounds));
    Ball& ball = bounds.ball;
    Box& box = bounds.box;
    const double sure_radius =
        above(ball.radius + shortfall_of_ball) + room + rounding_of(ball.radius);
    const double with_margin = ball.radius + (margin * ball.radius + of_places);
    ball.radius = with_margin > sure_radius ? with_margin : sure_radius;
    const glm::dvec3 more = margin * (box.high - box.low) + glm::dvec3{of_places};
    for (int i = 0; i < 3; ++i) {
        // Written so that a box that double could not hold gives way to the sure one.
        const double low = box.low[i] - more[i];
        const double high = box.high[i] + more[i];
        box.low[i] = low < sure.low[i] - room ? low : sure.low[i] - room;
        box.high[i] = high > sure.high[i] + room ? high : sure.high[i] + room;
    }
}

/// The first boxes are the balls' own, as double has their ends: these are off by a rounding.
void widen(Box& sure, const Ball& ball) {
    for (int i = 0; i < 3; ++i) {
        const double end = rounding_of(std::abs(ball.center[i]) + ball.radius);
        sure.low[i] = below(sure.low[i] - end);
        sure.high[i] = above(sure.high[i] + end);
    }
}

long edges_of(const Rifs& rifs) {
    long edges = 0;
    for (const FollowSet& set : rifs.follow_sets) edges += static_cast<long>(set.maps.size());
    return edges;
}

/// Shrinks boxes, then balls, one set at a time. Returns the largest share by which one may be
/// loose.
double tighten(const Rifs& rifs, Approximation& known) {
    const long sets = static_cast<long>(known.outer.size());
    const long edges = edges_of(rifs);
    const long budget = (first_budget + budget_per_edge * edges) / sets;
    double slack = 0;
    for (int s = 0; s < sets; ++s) {
        slack = std::max(slack, tighten_box(rifs, known, s, budget));
        if (edges <= large_graph) tighten_oriented_box(rifs, known, s, budget);
    }
    shrink_boxes(rifs, known);
    for (int s = 0; s < sets; ++s) {
        double& ball_slack = known.outer[s].ball_slack;
        ball_slack = tighten_ball(rifs, known, s, budget);
        slack = std::max(slack, ball_slack);
    }
    return slack;
}

/// Linear maps have no other attractor than the origin, and that is no matter of rounding.
bool stays_at_origin(const Rifs& rifs) {
    return std::ranges::all_of(
        rifs.maps, [](const Affine& map) { return map.translation == glm::dvec3{0.0}; });
}

}  // namespace

std::vector<Bounds> bound(const Rifs& rifs, const Contraction& contraction) {
    std::vector<Points> inner = inner_points(rifs);
    std::vector<Bounds> first = invariant_volumes(rifs, contraction, inner);
    Approximation known = approximation(first, std::move(inner));
    for (std::size_t s = 0; s < first.size(); ++s) widen(known.sure[s], first[s].ball);
    shrink_boxes(rifs, known);
    for (std::size_t s = 0; s < known.outer.size(); ++s) {
        const Box& box = known.outer[s].box;
        known.oriented[s] = as_oriented(box);
        known.shortfall[s].oriented = known.shortfall[s].box + shortfall_of_oriented(box);
    }
    const int rounds = edges_of(rifs) <= large_graph ? most_rounds : 1;
    // A further round starts from the volumes of the last and gets farther with the same budget.
    for (int round = 0; round < rounds; ++round) {
        if (round > 0) refine_by_grid(rifs, known);
        if (tighten(rifs, known) <= coarse) break;
    }
    for (std::size_t s = 0; s < known.outer.size(); ++s) {
        if (stays_at_origin(rifs)) {
            known.outer[s] = {{}, {}, known.outer[s].ball_slack};
        } else {
            add_margin(known.outer[s], known.sure[s], known.shortfall[s].ball);
        }
    }
    return known.outer;
}

}  // namespace pxm::host
