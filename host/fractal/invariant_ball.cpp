#include "host/fractal/invariant_ball.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "host/fractal/components.hpp"
#include "host/fractal/cycle_mean.hpp"
#include "host/fractal/enclosing_ball.hpp"
#include "host/fractal/lipschitz.hpp"
#include "host/fractal/quadratic_norm.hpp"
#include "host/fractal/words.hpp"

namespace pxm::host {

namespace {

constexpr double rounding = 1 + 1e-13;   // a factor that covers the rounding of one step
constexpr double safety = 1 + 1e-10;     // ... and of all of them
constexpr long work_limit = 10'000'000;  // steps looked at while centres are moved
constexpr long most_moves = 64;
constexpr int sweeps = 16;

/// map takes what stands in set `to` into set `from`; it is `lip` times as large there at most.
struct Step {
    int to;
    Affine map;
    double lip;
};

/// The system in coordinates where the steps contract: x of set s is frame[s] * x there.
struct Steps {
    std::vector<std::vector<Step>> from;  // by follow set
    std::vector<double> weight;           // lip weight[to] < weight[from] within a component
    std::vector<glm::dmat3> frame;
};

Steps plain_steps(const Rifs& rifs) {
    Steps steps;
    steps.frame.assign(rifs.follow_sets.size(), glm::dmat3{1.0});
    for (const double potential : largest_cycle_mean(rifs).potential) {
        steps.weight.push_back(std::exp(potential));
    }
    std::vector<double> lip;
    for (const Affine& map : rifs.maps) lip.push_back(lipschitz_constant(map) * rounding);
    for (const FollowSet& set : rifs.follow_sets) {
        std::vector<Step>& from = steps.from.emplace_back();
        for (const int m : set.maps) from.push_back({rifs.follow_of[m], rifs.maps[m], lip[m]});
    }
    return steps;
}

Steps framed_steps(const Rifs& rifs) {
    Steps steps;
    steps.frame = contracting_norm(rifs).value_or(QuadraticNorm{}).frame;
    steps.weight.assign(steps.frame.size(), 1.0);
    for (std::size_t s = 0; s < rifs.follow_sets.size(); ++s) {
        std::vector<Step>& from = steps.from.emplace_back();
        const glm::dmat3 into = glm::inverse(steps.frame[s]);
        for (const int m : rifs.follow_sets[s].maps) {
            const int to = rifs.follow_of[m];
            const Affine map{into * rifs.maps[m].linear * steps.frame[to],
                             into * rifs.maps[m].translation};
            from.push_back({to, map, lipschitz_constant(map) * rounding});
        }
    }
    return steps;
}

Steps word_steps(const Rifs& rifs) {
    Steps steps;
    steps.frame.assign(rifs.follow_sets.size(), glm::dmat3{1.0});
    steps.weight.assign(rifs.follow_sets.size(), 1.0);
    steps.from.resize(rifs.follow_sets.size());
    const WordCode code = contracting_words(rifs, word_budget).value_or(WordCode{});
    for (const ContractingWord& word : code.words) {
        steps.from[word.from].push_back({word.to, word.map, word.lip * rounding});
    }
    return steps;
}

Steps contracting_steps(const Rifs& rifs, ContractionProof proof) {
    switch (proof) {
        case ContractionProof::spectral_radius:
            return framed_steps(rifs);
        case ContractionProof::words:
            return word_steps(rifs);
        default:
            return plain_steps(rifs);
    }
}

/// Centres and radii such that every step takes the ball of `to` into the ball of its set.
class InvariantBalls {
  public:
    InvariantBalls(const Steps& steps, std::vector<int> component, std::vector<glm::dvec3> centers)
        : steps_(steps),
          component_(std::move(component)),
          center_(std::move(centers)),
          radius_(center_.size(), 0.0) {
        sets_.resize(center_.size() == 0 ? 0 : largest_component() + 1);
        long edges = 1;
        for (std::size_t s = 0; s < center_.size(); ++s) {
            sets_[component_[s]].push_back(static_cast<int>(s));
            edges += static_cast<long>(steps.from[s].size());
        }
        moves_ = std::clamp<long>(work_limit / edges, 1, most_moves);
    }

    std::vector<Ball> solve() {
        for (auto sets = sets_.rbegin(); sets != sets_.rend(); ++sets) solve_component(*sets);
        for (int i = 0; i < sweeps; ++i) sweep();
        std::vector<Ball> balls;
        for (std::size_t s = 0; s < center_.size(); ++s) {
            balls.push_back({center_[s], radius_[s] * safety});
        }
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

    /// Moves the centre that makes the balls large toward where its map stands still, in ever
    /// shorter moves, and keeps the best centres met.
    void solve_component(const std::vector<int>& sets) {
        double best = std::numeric_limits<double>::infinity();
        std::vector<glm::dvec3> best_centers;
        for (long move = 1; move <= moves_; ++move) {
            const Size size = smallest_size(sets);
            if (size.size < best || best_centers.empty()) {
                best = size.size;
                best_centers.clear();
                for (const int s : sets) best_centers.push_back(center_[s]);
            }
            if (size.step == nullptr) break;  // all radii are zero
            const glm::dvec3 target = size.step->to == size.set
                                          ? fixed_point(size.step->map)
                                          : size.step->map.point(center_[size.step->to]);
            center_[size.set] += (target - center_[size.set]) / static_cast<double>(move);
        }
        for (std::size_t i = 0; i < sets.size(); ++i) {
            center_[sets[i]] = best_centers[i];
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

    [[nodiscard]] double shift(int s, const Step& step) const {
        return glm::distance(step.map.point(center_[step.to]), center_[s]);
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

    const Steps& steps_;
    std::vector<int> component_;
    std::vector<glm::dvec3> center_;
    std::vector<double> radius_;
    std::vector<std::vector<int>> sets_;  // by component
    long moves_ = 1;
};

std::vector<glm::dvec3> first_centers(const Steps& steps, const std::vector<Points>& inner) {
    std::vector<glm::dvec3> centers;
    for (std::size_t s = 0; s < inner.size(); ++s) {
        const glm::dmat3 into = glm::inverse(steps.frame[s]);
        Points points;
        for (const glm::dvec3& point : inner[s]) points.push_back(into * point);
        centers.push_back(enclosing_ball(points).center);
    }
    return centers;
}

/// The ball and the box of frame * ball.
Bounds bounds_of(const glm::dmat3& frame, const Ball& ball) {
    Bounds bounds;
    bounds.ball.center = frame * ball.center;
    bounds.ball.radius = lipschitz_constant({frame, glm::dvec3{0.0}}) * ball.radius * safety;
    const glm::dmat3 rows = glm::transpose(frame);
    for (int i = 0; i < 3; ++i) {
        const double half = glm::length(rows[i]) * ball.radius * safety;
        bounds.box.low[i] = bounds.ball.center[i] - half;
        bounds.box.high[i] = bounds.ball.center[i] + half;
    }
    bounds.ball_slack = std::numeric_limits<double>::infinity();
    return bounds;
}

}  // namespace

std::vector<Bounds> invariant_volumes(const Rifs& rifs, const Contraction& contraction,
                                      const std::vector<Points>& inner) {
    const Steps steps = contracting_steps(rifs, contraction.proof);
    InvariantBalls balls(steps, set_components(rifs), first_centers(steps, inner));
    std::vector<Bounds> bounds;
    for (const Ball& ball : balls.solve()) {
        bounds.push_back(bounds_of(steps.frame[bounds.size()], ball));
    }
    return bounds;
}

}  // namespace pxm::host
