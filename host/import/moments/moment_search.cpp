#include "host/import/moments/moment_search.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <random>

#include "host/error.hpp"
#include "host/import/moments/collage.hpp"

namespace pxm::host {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr int parameters_a_map = 6;
constexpr int highest_order = 10;  // beyond, moments of one picture hardly differ
constexpr double most_lipschitz = 0.98;
constexpr int grid_cells = 200;
constexpr double enough_cells = 3;  // what pixels and the grid leave of an exact collage
constexpr long most_restarts = 100'000;

using Vector = Eigen::VectorXd;

/// The points moved and scaled so that their mean is 0 and they lie within [-1,1].
struct Frame2 {
    double x = 0, y = 0, unit = 1;
};

Frame2 frame_of(std::span<const WeightedPoint> points) {
    const PlaneMoments mean = moments_of(points, 1);
    Frame2 frame{mean[moment_index(1, 0)], mean[moment_index(0, 1)], 0};
    for (const WeightedPoint& p : points)
        frame.unit = std::max({frame.unit, std::abs(p.x - frame.x), std::abs(p.y - frame.y)});
    return frame;
}

std::vector<WeightedPoint> within(const Frame2& frame, std::span<const WeightedPoint> points) {
    std::vector<WeightedPoint> moved;
    moved.reserve(points.size());
    for (const WeightedPoint& p : points)
        moved.push_back({(p.x - frame.x) / frame.unit, (p.y - frame.y) / frame.unit, p.weight});
    return moved;
}

PlaneMap out_of(const Frame2& frame, const PlaneMap& w) {
    PlaneMap map = w;
    map.e = frame.unit * w.e + frame.x - w.a * frame.x - w.b * frame.y;
    map.f = frame.unit * w.f + frame.y - w.c * frame.x - w.d * frame.y;
    return map;
}

std::vector<PlaneMap> maps_of(const Vector& p) {
    std::vector<PlaneMap> maps;
    for (Eigen::Index i = 0; i + parameters_a_map <= p.size(); i += parameters_a_map)
        maps.push_back({p(i), p(i + 1), p(i + 2), p(i + 3), p(i + 4), p(i + 5)});
    return maps;
}

int order_for(int maps) {
    int order = 4;
    while (order < highest_order &&
           moment_count(order) < 2 * static_cast<std::size_t>(parameters_a_map * maps))
        ++order;
    return order;
}

/// The sum of squared differences between the moments of maps and of the target (Eq. 10.5 with
/// Erratum 8, in squares), each divided by the spread of what it is the mean of.
class Objective {
  public:
    Objective(std::span<const WeightedPoint> points, int order)
        : order_(order), target_(moments_of(points, order)) {
        const PlaneMoments spread = moments_of(points, 2 * order);
        for (int n = 0; n <= order; ++n)
            for (int i = n; i >= 0; --i)
                scale_.push_back(
                    1 / std::sqrt(std::max(1e-12, spread[moment_index(2 * i, 2 * (n - i))])));
    }

    [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(target_.size()); }

    /// Empty if a map does not contract.
    [[nodiscard]] std::optional<Vector> residual(const Vector& parameters) const {
        const auto maps = maps_of(parameters);
        for (const PlaneMap& map : maps)
            if (!(map.lipschitz() < most_lipschitz)) return std::nullopt;
        const PlaneMoments g = invariant_moments(maps, determinant_weights(maps), order_);
        Vector r(size());
        for (Eigen::Index m = 0; m < r.size(); ++m) {
            const auto k = static_cast<std::size_t>(m);
            r(m) = (g[k] - target_[k]) * scale_[k];
        }
        if (!r.allFinite()) return std::nullopt;
        return r;
    }

    /// d residual / d parameters, by one-sided differences.
    [[nodiscard]] Eigen::MatrixXd jacobian(const Vector& parameters, const Vector& r) const {
        constexpr double step = 1e-7;
        Eigen::MatrixXd j(r.size(), parameters.size());
        for (Eigen::Index k = 0; k < parameters.size(); ++k) {
            Vector moved = parameters;
            moved(k) += step;
            auto there = residual(moved);
            double h = step;
            if (!there) {
                moved(k) -= 2 * step;
                there = residual(moved);
                h = -step;
            }
            j.col(k) = there ? Vector((*there - r) / h) : Vector(Vector::Zero(r.size()));
        }
        return j;
    }

  private:
    int order_;
    PlaneMoments target_;
    std::vector<double> scale_;
};

struct Descent {
    Vector parameters;
    double square = infinite;  // of the residual
};

/// Follows the gradient with damped Gauss-Newton steps (Levenberg-Marquardt) to a local minimum.
Descent descend(const Objective& objective, Vector parameters, const std::function<bool()>& stop) {
    constexpr int most_steps = 120;
    constexpr double enough = 1e-24;
    auto r = objective.residual(parameters);
    if (!r) return {};
    double square = r->squaredNorm();
    double damping = 1e-2;
    for (int step = 0; step < most_steps && square > enough && !stop(); ++step) {
        const Eigen::MatrixXd j = objective.jacobian(parameters, *r);
        const Eigen::MatrixXd normal = j.transpose() * j;
        const Vector gradient = j.transpose() * *r;
        const double before = square;
        for (int attempt = 0; attempt < 8; ++attempt) {
            Eigen::MatrixXd damped = normal;
            damped.diagonal().array() += damping * (normal.diagonal().array() + 1e-9);
            const Vector moved = parameters - damped.ldlt().solve(gradient);
            const auto there = objective.residual(moved);
            if (there && there->squaredNorm() < square) {
                parameters = moved;
                r = there;
                square = there->squaredNorm();
                damping = std::max(damping / 5, 1e-12);
                break;
            }
            damping *= 5;
        }
        if (!(square < before * (1 - 1e-5))) break;
    }
    return {parameters, square};
}

/// Random maps that take the middle of the picture to points of it.
class Starts {
  public:
    Starts(std::span<const WeightedPoint> points, std::uint64_t seed, int maps)
        : points_(points), random_(seed), maps_(maps) {}

    Vector next() {
        const bool upright = pick(2) == 0;  // many pictures are made of copies that are not turned
        const double largest = std::min(0.85, 1.3 / std::sqrt(static_cast<double>(maps_)));
        Vector p(parameters_a_map * maps_);
        for (int k = 0; k < maps_; ++k) {
            const double turn = upright ? 0.1 * unit() : std::numbers::pi * unit();
            const double sx = largest * (0.7 + 0.25 * unit());
            const double sy = (pick(6) == 0 ? -1 : 1) * sx * (1 + 0.2 * unit());
            const WeightedPoint& at = points_[pick(points_.size())];
            p.segment(parameters_a_map * k, parameters_a_map) << sx * std::cos(turn),
                -sy * std::sin(turn), sx * std::sin(turn), sy * std::cos(turn), at.x, at.y;
        }
        return p;
    }

  private:
    // Not std::uniform_..._distribution: those differ from library to library.
    double unit() { return std::ldexp(static_cast<double>(random_() >> 11U), -52) - 1; }  // -1..1
    std::size_t pick(std::size_t count) { return random_() % count; }

    std::span<const WeightedPoint> points_;
    std::mt19937_64 random_;
    int maps_;
};

class Search {
  public:
    Search(std::span<const WeightedPoint> points, const MomentRequest& request)
        : request_(request), frame_(frame_of(points)) {
        if (!(frame_.unit > 0))
            throw Error(ErrorKind::scene, "nothing to import: the picture is a single point");
        moved_ = within(frame_, points);
    }

    MomentResult run() {
        const GridSet set(moved_, grid_cells, request_.finest / frame_.unit);
        MomentResult best;
        best.order = order_for(request_.maps);
        const Objective objective(moved_, best.order);
        Starts starts(moved_, request_.seed, request_.maps);
        best.bound = infinite;
        for (long restart = 0; restart < most_restarts; ++restart) {
            const Descent found = descend(objective, starts.next(), [&] { return over(); });
            take(found, set, objective, best);
            best.restarts = restart + 1;
            if (best.collage_distance <= enough_cells * set.cell() && best.bound < infinite) break;
            if (over() && best.bound < infinite) break;
            if (request_.stop && request_.stop()) break;
        }
        best.out_of_time = over();
        best.cell = set.cell();
        return in_the_picture(std::move(best));
    }

  private:
    [[nodiscard]] bool over() const {
        const auto now = std::chrono::steady_clock::now();
        return std::chrono::duration<double>(now - start_).count() > request_.seconds ||
               (request_.stop && request_.stop());
    }

    static void take(const Descent& found, const GridSet& set, const Objective& objective,
                     MomentResult& best) {
        if (found.square == infinite) return;
        const auto maps = maps_of(found.parameters);
        const double distance = set.collage_distance(maps);
        const double bound = collage_bound(distance, maps);
        if (!(bound < best.bound)) return;
        best.maps = maps;
        best.weights = determinant_weights(maps);
        best.residual = std::sqrt(found.square / static_cast<double>(objective.size()));
        best.collage_distance = distance;
        best.bound = bound;
    }

    /// From the frame of the search to that of the points.
    [[nodiscard]] MomentResult in_the_picture(MomentResult result) const {
        for (PlaneMap& map : result.maps) map = out_of(frame_, map);
        for (double* length : {&result.collage_distance, &result.bound, &result.cell})
            *length *= frame_.unit;
        double low_x = infinite, high_x = -infinite, low_y = infinite, high_y = -infinite;
        for (const WeightedPoint& p : moved_) {
            low_x = std::min(low_x, p.x);
            high_x = std::max(high_x, p.x);
            low_y = std::min(low_y, p.y);
            high_y = std::max(high_y, p.y);
        }
        result.size = std::max(high_x - low_x, high_y - low_y) * frame_.unit;
        return result;
    }

    const MomentRequest& request_;
    Frame2 frame_;
    std::vector<WeightedPoint> moved_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace

MomentResult search_moments(std::span<const WeightedPoint> points, const MomentRequest& request) {
    return Search(points, request).run();
}

}  // namespace pxm::host
