#include "host/compile/short_by.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "host/fractal/bounds/farthest.hpp"
#include "host/fractal/bounds/support.hpp"
#include "host/math/rounding.hpp"
#include "host/process/give_up.hpp"

namespace pxm::host {

namespace {

constexpr double margin = 1e-9;              // of the size, as bound() adds it
constexpr double coordinate_margin = 1e-11;  // of the coordinates, for their rounding
constexpr long budget = 1'000'000;           // cells looked at for one reach
constexpr int most_reaches = 600;            // for one mantle
constexpr double share = 1e-3;               // of what sticks out: told this exactly

/// Reaches of one set, rounding or not, and which of their differences a scene's own numbers may be
/// off by.
class Excess {
  public:
    /// `known` must outlive it.
    Excess(const Rifs& rifs, const Approximation& known, const Bounds& own, int set)
        : rifs_(rifs), set_(set), known_(known) {
        const glm::dvec3 farthest = glm::max(glm::abs(own.box.low), glm::abs(own.box.high));
        farthest_ = std::max({farthest.x, farthest.y, farthest.z});
        rounding_ = margin * own.ball.radius + coordinate_margin * farthest_;
    }

    [[nodiscard]] double over(const SphereVolume& volume) const {
        const FarthestGoal goal{volume.radius + rounding_, rounding_, share, budget};
        return above(farthest(rifs_, known_, set_, volume.center, goal).at_most() - volume.radius);
    }
    [[nodiscard]] double over(const BoxVolume& volume) const {
        double over = -std::numeric_limits<double>::infinity();
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 u{0.0};
            u[axis] = 1;
            over = std::max({over, above(reach_along(u) - volume.high[axis]),
                             above(reach_along(-u) + volume.low[axis])});
        }
        return over;
    }
    [[nodiscard]] double over(const ConeVolume&) const {
        // The mantle's tangent planes are e . x + y = 1, e horizontal: normals sqrt(2) long.
        return std::max(reach_along({0, -1, 0}), over_mantle(1) / std::numbers::sqrt2);
    }
    [[nodiscard]] double over(const CylinderVolume&) const {
        return std::max({reach_along({0, 1, 0}) - 1, reach_along({0, -1, 0}) - 1, over_mantle(0)});
    }
    [[nodiscard]] double over(const AutoVolume&) const { return 0; }
    [[nodiscard]] double over(const HullVolume&) const { return 0; }

    [[nodiscard]] double rounding() const { return rounding_; }

  private:
    /// Horizontal directions between two angles, with the reach at both.
    struct Arc {
        double from, to;
        double over_from, over_to;
    };

    [[nodiscard]] double reach_along(const glm::dvec3& u) const {
        return reach(rifs_, known_, set_, u, rounding_, budget).at_most();
    }

    /// h(e + slope y) - 1 at a horizontal direction e of that angle and length.
    [[nodiscard]] double over_at(double angle, double length, double slope) const {
        const glm::dvec3 u{length * std::cos(angle), slope, length * std::sin(angle)};
        // The direction itself is rounded, and with it how far that is.
        const double of_direction = rounding_of(sum_of_parts(u) * (1 + farthest_));
        return above(reach_along(u) - 1 + of_direction);
    }

    /// The most that h(e + slope y) exceeds 1 for a horizontal unit vector e. The directions of an
    /// arc lie in the triangle of its ends and the point where their tangents meet, and h is
    /// convex: on the arc it is no larger than at one of these three.
    [[nodiscard]] double over_mantle(double slope) const {
        constexpr double quarter = std::numbers::pi / 2;
        std::vector<Arc> open;
        double ends[4];
        for (int i = 0; i < 4; ++i) ends[i] = over_at(i * quarter, 1, slope);
        for (int i = 0; i < 4; ++i) {
            open.push_back({i * quarter, (i + 1) * quarter, ends[i], ends[(i + 1) % 4]});
        }
        double most = *std::ranges::max_element(ends);
        for (int left = most_reaches; !open.empty(); --left) {
            const Arc arc = open.back();
            open.pop_back();
            const double middle = (arc.from + arc.to) / 2;
            const double on_tangents =
                over_at(middle, 1 / std::cos((arc.to - arc.from) / 2), slope);
            const double upper = std::max({arc.over_from, arc.over_to, on_tangents});
            if (upper <= rounding_ || upper <= most * (1 + share) || left <= 0) {
                most = std::max(most, upper);
                continue;
            }
            const double on_arc = over_at(middle, 1, slope);
            most = std::max(most, on_arc);
            open.push_back({arc.from, middle, arc.over_from, on_arc});
            open.push_back({middle, arc.to, on_arc, arc.over_to});
        }
        return most;
    }

    const Rifs& rifs_;
    int set_;
    const Approximation& known_;
    double farthest_;  // coordinate of a point
    double rounding_;
};

}  // namespace

namespace {

double short_by(const Excess& excess, const DeclaredVolume& volume) {
    const double over = std::visit([&](const auto& v) { return excess.over(v); }, volume);
    return over <= excess.rounding() ? std::min(over, 0.0) : over;
}

}  // namespace

double short_by(const Rifs& rifs, const std::vector<Bounds>& bounds, int set,
                const DeclaredVolume& volume) {
    const Approximation known = approximation(rifs, bounds);
    return short_by(Excess(rifs, known, bounds[static_cast<std::size_t>(set)], set), volume);
}

std::vector<double> short_by(const Rifs& rifs, const std::vector<Bounds>& bounds,
                             const DeclaredVolume& volume) {
    const Approximation known = approximation(rifs, bounds);
    std::vector<double> by;
    for (std::size_t set = 0; set < bounds.size(); ++set) {
        give_up_if_asked();
        by.push_back(short_by(Excess(rifs, known, bounds[set], static_cast<int>(set)), volume));
    }
    return by;
}

}  // namespace pxm::host
