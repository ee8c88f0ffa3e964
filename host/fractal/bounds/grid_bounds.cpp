#include "host/fractal/bounds/grid_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "host/fractal/bounds/enclosing_ball.hpp"
#include "host/process/give_up.hpp"

namespace pxm::host {

namespace {

constexpr long work_limit = 30'000'000;  // maps looked at, over all directions and rounds
constexpr int coarsest = 4;              // steps of the grid: 66 directions
constexpr int finest = 32;               // 4,098 directions
constexpr long expected_rounds = 50;
constexpr double settled = 1e-5;  // of a set's size: rounds that change less are the last
constexpr int most_moves = 200;   // of a ball's centre
constexpr long rollout_work = 3'000'000;
constexpr long longest_rollout = 2'000;  // maps
constexpr double on_surface = 1 - 1e-9;  // of a ball's radius
constexpr double rollout_end = 1e-6;     // of the direction's length

int directions_of(int steps) { return 4 * steps * steps + 2; }

long edges_of(const Rifs& rifs) {
    long edges = 0;
    for (const FollowSet& set : rifs.follow_sets) edges += static_cast<long>(set.maps.size());
    return edges;
}

SupportGrid grid_of(const Approximation& known, int steps) {
    std::vector<glm::dvec3> centers;
    std::vector<double> extents;
    for (std::size_t s = 0; s < known.outer.size(); ++s) {
        const Ball& ball = known.outer[s].ball;
        centers.push_back(ball.center);
        extents.push_back(above(ball.radius + known.shortfall[s].ball));
    }
    SupportGrid grid(steps, centers, extents);
    for (std::size_t s = 0; s < centers.size(); ++s) {
        const int set = static_cast<int>(s);
        for (int i = 0; i < grid.directions().size(); ++i) {
            const glm::dvec3& u = grid.directions().point(i);
            const auto [reach, rounding] = volume_support(known, set, u);
            const double terms = std::abs(reach) + dot_of_parts(u, centers[s]);
            grid.set_value(set, i,
                           {reach - glm::dot(u, centers[s]), rounding + rounding_of(terms)});
        }
    }
    return grid;
}

/// By how much the grid's own rounding may keep a ball about `center` from holding the set. At
/// grid points u, |u| is no shorter than steps / sqrt 3.
double ball_rounding(const SupportGrid& grid, int set, const Ball& ball) {
    const DirectionGrid& directions = grid.directions();
    double most = 0;
    for (int i = 0; i < directions.size(); ++i) {
        if (!directions.is_point(i)) continue;
        const auto& [value, rounding] = grid.value(set, i);
        const glm::dvec3& u = directions.point(i);
        const double terms =
            std::abs(value) + dot_of_parts(u, glm::abs(ball.center) + glm::abs(grid.center(set)));
        most = std::max(most, rounding + rounding_of(terms));
    }
    // The bulge and its product with the radius take some sixty operations more.
    return 4 * most / directions.steps() + 8 * rounding_of(ball.radius);
}

/// The smallest ball the grid allows: its centre moves away from where it is largest, in ever
/// shorter moves. True if it is smaller than the one before.
bool shrink_ball(const SupportGrid& grid, int set, Ball& ball) {
    const DirectionGrid& directions = grid.directions();
    const double bulge = directions.bulge();
    glm::dvec3 center = grid.center(set);
    bool shrunk = false;
    for (int move = 1; move <= most_moves; ++move) {
        double radius = 0;
        glm::dvec3 worst{0.0};
        for (int i = 0; i < directions.size(); ++i) {
            if (!directions.is_point(i)) continue;
            const glm::dvec3& u = directions.point(i);
            const double reach = grid.value(set, i).value - glm::dot(u, center - grid.center(set));
            if (reach <= radius * glm::length(u)) continue;
            radius = reach / glm::length(u);
            worst = glm::normalize(u);
        }
        if (radius * bulge < ball.radius) {
            ball = {center, radius * bulge};
            shrunk = true;
        }
        center += worst * (radius / (move + 1));
    }
    return shrunk;
}

/// A point of E_set that reaches far in direction u: the maps that the grid thinks best, one after
/// the other.
glm::dvec3 far_point(const Rifs& rifs, const Approximation& known, int set, glm::dvec3 u,
                     long longest) {
    std::vector<int> word;
    const double end = glm::length(u) * rollout_end;
    while (glm::length(u) > end && static_cast<long>(word.size()) < longest) {
        word.push_back(known.grid.best_map(rifs, set, u));
        u = u * rifs.maps[word.back()].linear;
        set = rifs.follow_of[word.back()];
    }
    glm::dvec3 point = extreme(known.inner[set], u);
    for (auto m = word.rbegin(); m != word.rend(); ++m) point = rifs.maps[*m].point(point);
    return point;
}

/// A few points that say almost as much as all: the extremes, and those that hold the smallest
/// ball.
Points most_useful(const Points& points) {
    Points useful = extremes_of(points);
    const Ball ball = enclosing_ball(points);
    for (const glm::dvec3& point : points) {
        if (glm::distance(point, ball.center) > ball.radius * on_surface) useful.push_back(point);
    }
    return useful;
}

}  // namespace

void refine_by_grid(const Rifs& rifs, Approximation& known) {
    const long edges = edges_of(rifs);
    const auto affordable = [&](int steps) {
        return edges * directions_of(steps) * expected_rounds <= work_limit;
    };
    long work = 0;
    for (int steps = coarsest; steps <= finest && affordable(steps); steps *= 2) {
        known.grid = grid_of(known, steps);
        do {
            work += edges * directions_of(steps);
        } while (known.grid.iterate(rifs) > settled && work < work_limit);
    }
    if (known.grid.empty()) return;
    const DirectionGrid few(coarsest);
    const long sets = static_cast<long>(known.outer.size());
    const long longest =
        std::clamp<long>(rollout_work / (edges * directions_of(coarsest)), 1, longest_rollout);
    for (int s = 0; s < sets; ++s) {
        give_up_if_asked();
        Ball& ball = known.outer[s].ball;
        if (shrink_ball(known.grid, s, ball)) {
            known.shortfall[s].ball = ball_rounding(known.grid, s, ball);
        }
        Points points = known.inner[s];
        for (int i = 0; i < few.size(); ++i) {
            if (few.is_point(i)) points.push_back(far_point(rifs, known, s, few.point(i), longest));
        }
        known.inner[s] = most_useful(points);
    }
}

}  // namespace pxm::host
