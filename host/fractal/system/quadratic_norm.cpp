#include "host/fractal/system/quadratic_norm.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "host/math/bracket_matrix.hpp"
#include "host/math/eigen_matrix.hpp"
#include "host/math/spectrum.hpp"

namespace pxm::host {

namespace {

constexpr long work_limit = 20'000'000;  // products of two matrices
constexpr int most_steps = 400;
constexpr int fewest_steps = 4;

using Matrix = Eigen::Matrix3d;
using Shapes = std::vector<Matrix>;  // symmetric positive, one for each follow set

/// The operator sum T (x) T by blocks: set s gets the sum of M P_t M^T over its maps.
Shapes apply(const Rifs& rifs, const Shapes& linear, const Shapes& shapes) {
    Shapes image(shapes.size(), Matrix::Zero());
    for (std::size_t s = 0; s < shapes.size(); ++s) {
        for (const int m : rifs.follow_sets[s].maps) {
            image[s] += linear[m] * shapes[rifs.follow_of[m]] * linear[m].transpose();
        }
    }
    return image;
}

double total_trace(const Shapes& shapes) {
    double sum = 0;
    for (const Matrix& shape : shapes) sum += shape.trace();
    return sum;
}

int steps_for(const Rifs& rifs) {
    long edges = 1;
    for (const FollowSet& set : rifs.follow_sets) edges += static_cast<long>(set.maps.size());
    const long steps = work_limit / edges;
    return static_cast<int>(std::clamp<long>(steps, fewest_steps, most_steps));
}

/// The growth rate of the operator, by power iteration: an estimate only.
double estimated_radius(const Rifs& rifs, const Shapes& linear, int steps) {
    Shapes shapes(rifs.follow_sets.size(), Matrix::Identity());
    double log_growth = 0;
    int counted = 0;
    for (int step = 0; step < steps; ++step) {
        const double before = total_trace(shapes);
        shapes = apply(rifs, linear, shapes);
        const double after = total_trace(shapes);
        if (!(after > 0)) return 0;  // nilpotent
        if (step >= steps / 2) {     // the first half forgets the start
            log_growth += std::log(after / before);
            ++counted;
        }
        for (Matrix& shape : shapes) shape /= after;
    }
    return std::exp(log_growth / counted);
}

/// No smaller than any map's norm from the ellipsoid it finds to the one it leads into.
double proven_rate(const Rifs& rifs, const std::vector<glm::dmat3>& frame) {
    double rate = 0;
    for (std::size_t s = 0; s < frame.size(); ++s) {
        const BracketMatrix into = inverse_of_lower(frame[s]);
        for (const int m : rifs.follow_sets[s].maps) {
            const BracketMatrix inner{frame[static_cast<std::size_t>(rifs.follow_of[m])]};
            rate =
                std::max(rate, norm_at_most(into * (BracketMatrix{rifs.maps[m].linear} * inner)));
            if (!(rate < 1)) return rate;
        }
    }
    return rate;
}

}  // namespace

std::optional<QuadraticNorm> contracting_norm(const Rifs& rifs) {
    Shapes linear;
    for (const Affine& map : rifs.maps) linear.push_back(eigen_matrix(map.linear));
    const int steps = steps_for(rifs);
    const double radius = estimated_radius(rifs, linear, steps);
    if (!(radius < 1)) return std::nullopt;
    // P <- I + A P / mu with radius < mu < 1 tends to a positive P with A P <= mu P.
    const double mu = (1 + radius) / 2;
    Shapes shapes(rifs.follow_sets.size(), Matrix::Identity());
    for (int step = 0; step < steps; ++step) {
        Shapes image = apply(rifs, linear, shapes);
        for (std::size_t s = 0; s < image.size(); ++s)
            shapes[s] = Matrix::Identity() + image[s] / mu;
    }
    const Shapes image = apply(rifs, linear, shapes);
    QuadraticNorm norm;
    double rho = 0;
    for (std::size_t s = 0; s < shapes.size(); ++s) {
        const glm::dmat3 shape = glm_matrix(shapes[s]);
        // image <= rho shape fails below it (Collatz and Wielandt, for matrices).
        const auto ratio = largest_ratio(glm_matrix(image[s]), shape);
        const auto frame = lower_root(shape);
        if (!ratio || !frame) return std::nullopt;
        rho = std::max(rho, *ratio);
        norm.frame.push_back(*frame);
    }
    if (!(rho < 1)) return std::nullopt;
    norm.rate = std::max(std::sqrt(rho), proven_rate(rifs, norm.frame));
    if (!(norm.rate < 1)) return std::nullopt;
    return norm;
}

}  // namespace pxm::host
