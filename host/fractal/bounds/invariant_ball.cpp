#include "host/fractal/bounds/invariant_ball.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <utility>

#include "host/fractal/bounds/contracting_steps.hpp"
#include "host/fractal/bounds/enclosing_ball.hpp"
#include "host/fractal/system/components.hpp"
#include "host/math/lipschitz.hpp"
#include "host/process/give_up.hpp"

namespace pxm::host {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double rounding = 1 + 1e-13;   // a factor that covers the rounding of one step
constexpr double safety = 1 + 1e-10;     // ... and of all of them
constexpr long work_limit = 10'000'000;  // steps looked at while centres are moved
constexpr long most_moves = 64;
constexpr int sweeps = 16;

/// Centres and radii such that every step takes the ball of `to` into the ball of its set.
class InvariantBalls {
  public:
    InvariantBalls(const Steps& steps, std::vector<int> component, std::vector<glm::dvec3> centers)
        : steps_(steps),
          component_(std::move(component)),
          center_(std::move(centers)),
          radius_(center_.size(), 0.0),
          leading_to_(center_.size()),
          image_(steps.maps.size()) {
        sets_.resize(center_.size() == 0 ? 0 : largest_component() + 1);
        long edges = 1;
        for (std::size_t s = 0; s < center_.size(); ++s) {
            sets_[component_[s]].push_back(static_cast<int>(s));
            edges += static_cast<long>(steps.from[s].size());
        }
        find_leading_maps();
        moves_ = std::clamp<long>(work_limit / edges, 1, most_moves);
    }

    std::vector<Ball> solve() {
        for (auto sets = sets_.rbegin(); sets != sets_.rend(); ++sets) solve_component(*sets);
        for (int i = 0; i < sweeps; ++i) sweep();
        for (double& radius : radius_) radius *= safety;
        for (auto sets = sets_.rbegin(); sets != sets_.rend(); ++sets) make_sure_of(*sets);
        std::vector<Ball> balls;
        for (std::size_t s = 0; s < center_.size(); ++s) balls.push_back({center_[s], radius_[s]});
        return balls;
    }

  private:
    /// The radii of a component are `size` times the weights of its sets; `step` allows no less.
    struct Size {
        double size = 0;
        int set = 0;
        const Step* step = nullptr;
    };

    [[nodiscard]] std::size_t largest_component() const {
        return static_cast<std::size_t>(*std::max_element(component_.begin(), component_.end()));
    }

    void find_leading_maps() {
        std::vector<char> seen(steps_.maps.size(), 0);
        for (const std::vector<Step>& from : steps_.from) {
            for (const Step& step : from) {
                if (!std::exchange(seen[step.map], char{1})) {
                    leading_to_[step.to].push_back(step.map);
                }
            }
        }
        for (std::size_t s = 0; s < center_.size(); ++s) move(static_cast<int>(s), center_[s]);
    }

    void move(int set, const glm::dvec3& center) {
        center_[set] = center;
        for (const int m : leading_to_[set]) image_[m] = steps_.maps[m].map.point(center);
    }

    /// Moves the centre that makes the balls large toward where its map stands still, in ever
    /// shorter moves, and keeps the best centres met.
    void solve_component(const std::vector<int>& sets) {
        double best = infinity;
        std::vector<glm::dvec3> best_centers;
        for (long step = 1; step <= moves_; ++step) {
            give_up_if_asked();
            const Size size = smallest_size(sets);
            if (size.size < best || best_centers.empty()) {
                best = size.size;
                best_centers.clear();
                for (const int s : sets) best_centers.push_back(center_[s]);
            }
            if (size.step == nullptr) break;  // all radii are zero
            const glm::dvec3 target = size.step->to == size.set
                                          ? still_point(size.set, *size.step)
                                          : image_of_center(size.set, *size.step);
            const glm::dvec3& from = center_[size.set];
            move(size.set, from + (target - from) / static_cast<double>(step));
        }
        for (std::size_t i = 0; i < sets.size(); ++i) {
            move(sets[i], best_centers[i]);
            radius_[sets[i]] = best * steps_.weight[sets[i]];
        }
    }

    Size smallest_size(const std::vector<int>& sets) const {
        Size result;
        for (const int s : sets) {
            for (const Step& step : steps_.from[s]) {
                const double size = size_for(s, step);
                if (size > result.size) result = {size, s, &step};
            }
        }
        return result;
    }

    /// size w_s >= distance + lip size w_t within a component, >= distance + lip radius_t across.
    [[nodiscard]] double size_for(int s, const Step& step) const {
        const double distance = shift(s, step);
        const double own = steps_.weight[s];
        if (component_[step.to] == component_[s]) {
            return distance / (own - step.lip * steps_.weight[step.to]);
        }
        return (distance + step.lip * radius_[step.to]) / own;
    }

    /// In the coordinates of set s, as all centres are in those of their sets.
    [[nodiscard]] glm::dvec3 image_of_center(int s, const Step& step) const {
        if (!steps_.frames) return image_[step.map];
        const Affine& map = steps_.maps[step.map].map;
        const auto& [frame, into, proven_into] = *steps_.frames;
        return into[s] * map.point(frame[step.to] * center_[step.to]);
    }

    [[nodiscard]] glm::dvec3 still_point(int s, const Step& step) const {
        const glm::dvec3 point = fixed_point(steps_.maps[step.map].map);
        return steps_.frames ? steps_.frames->into[s] * point : point;
    }

    [[nodiscard]] double shift(int s, const Step& step) const {
        return glm::distance(image_of_center(s, step), center_[s]);
    }

    /// Radii that are large enough stay so when each is made no larger than its steps need.
    void sweep() {
        for (auto sets = sets_.rbegin(); sets != sets_.rend(); ++sets) {
            for (const int s : *sets) {
                double needed = 0;
                for (const Step& step : steps_.from[s]) {
                    needed = std::max(needed, shift(s, step) + step.lip * radius_[step.to]);
                }
                radius_[s] = std::min(radius_[s], needed * rounding);
            }
        }
    }

    /// What was computed in double becomes certain: radii that turn out too small get the size that
    /// brackets ask for, or none.
    void make_sure_of(const std::vector<int>& sets) {
        if (are_large_enough(sets)) return;
        double size = 0;
        for (const int s : sets) {
            for (const Step& step : steps_.from[s]) size = std::max(size, sure_size_for(s, step));
        }
        for (const int s : sets) {
            const double sure = size * steps_.weight[s] * safety;
            if (!(radius_[s] >= sure)) radius_[s] = sure;
        }
        if (are_large_enough(sets)) return;
        for (const int s : sets) radius_[s] = infinity;
    }

    /// True if the steps are sure to take balls into the balls of these sets.
    [[nodiscard]] bool are_large_enough(const std::vector<int>& sets) const {
        return std::ranges::all_of(sets, [this](int s) {
            return std::ranges::all_of(steps_.from[s], [this, s](const Step& step) {
                const Bracket inside = Bracket{step.lip} * radius_[step.to];
                return (sure_shift(s, step) + inside).high <= radius_[s];
            });
        });
    }

    /// As size_for().
    [[nodiscard]] double sure_size_for(int s, const Step& step) const {
        const Bracket distance = sure_shift(s, step);
        const Bracket own = steps_.weight[s];
        const Bracket lip = step.lip;
        if (component_[step.to] == component_[s]) {
            return (distance / (own - lip * steps_.weight[step.to])).high;
        }
        return ((distance + lip * radius_[step.to]) / own).high;
    }

    [[nodiscard]] Bracket sure_shift(int s, const Step& step) const {
        const auto& [map, linear, translation] = steps_.maps[step.map];
        const BracketVector from = bracket(center_[step.to]);
        const BracketVector at = bracket(center_[s]);
        if (!steps_.frames) return length(linear * from + translation - at);
        const auto& [frame, into, proven_into] = *steps_.frames;
        const BracketVector image = linear * (BracketMatrix{frame[step.to]} * from) + translation;
        return length(proven_into[s] * (image - BracketMatrix{frame[s]} * at));
    }

    const Steps& steps_;
    std::vector<int> component_;
    std::vector<glm::dvec3> center_;
    std::vector<double> radius_;
    std::vector<std::vector<int>> leading_to_;  // per set, the maps that it may stand inside of
    std::vector<glm::dvec3> image_;             // per map, of the centre of what stands inside
    std::vector<std::vector<int>> sets_;        // by component
    long moves_ = 1;
};

std::vector<glm::dvec3> first_centers(const Steps& steps, const std::vector<Points>& inner) {
    std::vector<glm::dvec3> centers;
    for (std::size_t s = 0; s < inner.size(); ++s) {
        Points points = inner[s];
        if (steps.frames) {
            for (glm::dvec3& point : points) point = steps.frames->into[s] * point;
        }
        centers.push_back(enclosing_ball(points).center);
    }
    return centers;
}

Bounds everything() {
    return {{glm::dvec3{0.0}, infinity}, {glm::dvec3{-infinity}, glm::dvec3{infinity}}, infinity};
}

/// The box of a ball, with the ball.
Bounds bounds_of(const Ball& ball) {
    if (!(ball.radius < infinity)) return everything();
    const glm::dvec3 half{ball.radius * safety};
    return {
        {ball.center, ball.radius * safety}, {ball.center - half, ball.center + half}, infinity};
}

/// The ball and the box of frame * ball.
Bounds bounds_of(const glm::dmat3& frame, const Ball& ball) {
    if (!(ball.radius < infinity)) return everything();
    const BracketVector center = BracketMatrix{frame} * bracket(ball.center);
    const glm::dmat3 rows = glm::transpose(frame);
    Bounds bounds;
    bounds.ball.center = frame * ball.center;
    const Bracket lip = norm_at_most(frame);
    bounds.ball.radius =
        (lip * ball.radius + length(center - bracket(bounds.ball.center))).high * safety;
    for (int i = 0; i < 3; ++i) {
        const Bracket half = length(bracket(rows[i])) * ball.radius * safety;
        bounds.box.low[i] = (center[static_cast<std::size_t>(i)] - half).low;
        bounds.box.high[i] = (center[static_cast<std::size_t>(i)] + half).high;
    }
    bounds.ball_slack = infinity;
    return bounds;
}

}  // namespace

std::vector<Bounds> invariant_volumes(const Rifs& rifs, const Contraction& contraction,
                                      const std::vector<Points>& inner) {
    const auto steps = contracting_steps(rifs, contraction.proof);
    if (!steps) return std::vector<Bounds>(rifs.follow_sets.size(), everything());
    InvariantBalls balls(*steps, set_components(rifs), first_centers(*steps, inner));
    std::vector<Bounds> bounds;
    for (const Ball& ball : balls.solve()) {
        bounds.push_back(steps->frames ? bounds_of(steps->frames->frame[bounds.size()], ball)
                                       : bounds_of(ball));
    }
    return bounds;
}

}  // namespace pxm::host
