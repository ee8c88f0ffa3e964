#include "host/fractal/measure/moments.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "host/fractal/system/sensitivity.hpp"
#include "host/math/lipschitz.hpp"

namespace pxm::host {

namespace {

constexpr std::size_t most_rounds = 20'000;
constexpr std::size_t most_steps = 30'000'000;  // maps applied: a second or two
constexpr double at_rest = 1e-15;               // of the size

/// Probabilities within each follow set, beside its maps.
std::vector<std::vector<double>> probabilities(const Rifs& rifs,
                                               const std::vector<double>& weights) {
    std::vector<std::vector<double>> of_sets;
    for (const FollowSet& set : rifs.follow_sets) {
        auto& shares = of_sets.emplace_back();
        double sum = 0;
        for (const int m : set.maps) {
            shares.push_back(weights[static_cast<std::size_t>(m)]);
            sum += shares.back();
        }
        for (double& share : shares) share /= sum;
    }
    return of_sets;
}

struct Mean {
    glm::dvec3 first{0.0};
    glm::dmat3 second{0.0};  // of x x^T, around `origin`
};

double difference(const Mean& a, const Mean& b) {
    double far = 0;
    for (int i = 0; i < 3; ++i) {
        far = std::max(far, std::abs(a.first[i] - b.first[i]));
        for (int j = 0; j < 3; ++j) far = std::max(far, std::abs(a.second[i][j] - b.second[i][j]));
    }
    return far;
}

/// One application of the measure's equation to the means of all follow sets.
std::vector<Mean> applied(const Rifs& rifs, const std::vector<std::vector<double>>& shares,
                          const std::vector<Mean>& means) {
    std::vector<Mean> next(means.size());
    for (std::size_t s = 0; s < means.size(); ++s) {
        const std::vector<int>& maps = rifs.follow_sets[s].maps;
        for (std::size_t i = 0; i < maps.size(); ++i) {
            const auto m = static_cast<std::size_t>(maps[i]);
            const Affine& map = rifs.maps[m];
            const Mean& inside = means[static_cast<std::size_t>(rifs.follow_of[m])];
            const glm::dvec3 moved = map.linear * inside.first;
            const glm::dvec3& a = map.translation;
            next[s].first += shares[s][i] * (moved + a);
            next[s].second +=
                shares[s][i] * (map.linear * inside.second * glm::transpose(map.linear) +
                                glm::outerProduct(moved, a) + glm::outerProduct(a, moved) +
                                glm::outerProduct(a, a));
        }
    }
    return next;
}

/// Of first and of second moments.
struct Sizes {
    double first = 0;
    double second = 0;
};

Sizes differences(const std::vector<Mean>& a, const std::vector<Mean>& b) {
    Sizes far;
    for (std::size_t s = 0; s < a.size(); ++s)
        for (int i = 0; i < 3; ++i) {
            far.first = std::max(far.first, std::abs(a[s].first[i] - b[s].first[i]));
            for (int j = 0; j < 3; ++j)
                far.second = std::max(far.second, std::abs(a[s].second[i][j] - b[s].second[i][j]));
        }
    return far;
}

/// The largest sums of magnitudes that entries of applied() are made of.
Sizes magnitudes_of(const Rifs& rifs, const std::vector<Mean>& means) {
    Sizes largest;
    for (std::size_t m = 0; m < rifs.maps.size(); ++m) {
        const Affine& map = rifs.maps[m];
        const Mean& inside = means[static_cast<std::size_t>(rifs.follow_of[m])];
        double stretch = 0, moved = 0, first = 0, second = 0;
        for (int i = 0; i < 3; ++i) {
            moved += std::abs(map.translation[i]);
            first += std::abs(inside.first[i]);
            for (int j = 0; j < 3; ++j) {
                stretch += std::abs(map.linear[i][j]);
                second += std::abs(inside.second[i][j]);
            }
        }
        largest.first = std::max(largest.first, stretch * first + moved);
        largest.second = std::max(largest.second, stretch * stretch * second +
                                                      2 * stretch * first * moved + moved * moved);
    }
    return largest;
}

/// The measure's equation takes errors to smaller ones: what is left when it is applied once more,
/// and what rounding may hide of that, bound how far the means are from the true ones.
void add_errors(const Rifs& rifs, const std::vector<std::vector<double>>& shares,
                const std::vector<Mean>& means, Moments& found) {
    constexpr double unit = 0x1p-52;
    constexpr double operations = 40;  // of one term of a sum
    constexpr double entries = 3;      // the norm of a matrix, over its largest entry
    const Sensitivity most = sensitivity(rifs);
    const std::vector<Mean> next = applied(rifs, shares, means);
    const Sizes rest = differences(next, means);
    const Sizes magnitudes = magnitudes_of(rifs, means);
    std::size_t terms = 0;
    for (const FollowSet& set : rifs.follow_sets) terms = std::max(terms, set.maps.size());
    const double hidden = unit * (operations + 2 * static_cast<double>(terms));
    const double first = entries * most.lipschitz * (rest.first + hidden * magnitudes.first);
    // An error of the mean is in the equation of the second moments, too.
    double moved = 0, stretch = 0;
    for (const Affine& map : rifs.maps) {
        moved = std::max(moved, glm::length(map.translation));
        stretch = std::max(stretch, lipschitz_constant(map));
    }
    const double second = entries * most.squares *
                          (rest.second + hidden * magnitudes.second + 2 * stretch * moved * first);
    const double center = glm::length(found.centroid);
    double size = 0;
    for (int i = 0; i < 3; ++i) size += glm::length(found.covariance[i]);
    found.centroid_error = first * (1 + unit * operations);
    found.variance_error = (second + 2 * center * first + first * first) * (1 + unit * operations) +
                           unit * operations * (size + center * center);
    for (std::size_t i = 0; i < 3; ++i) {  // Davis and Kahan's theorem
        double gap = INFINITY;
        for (std::size_t j = 0; j < 3; ++j)
            if (j != i) gap = std::min(gap, std::abs(found.variances[i] - found.variances[j]));
        const double apart = gap - 2 * found.variance_error;
        const double sine = 2 * found.variance_error / apart;
        found.axis_errors[i] = apart > 0 && sine < 1 ? sine : 1;
    }
}

void add_axes(Moments& found) {
    Eigen::Matrix3d matrix;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) matrix(i, j) = found.covariance[i][j];
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix);
    for (int i = 0; i < 3; ++i) {
        const int from = 2 - i;  // they come rising
        const auto to = static_cast<std::size_t>(i);
        found.variances[to] = std::max(0.0, solver.eigenvalues()[from]);
        glm::dvec3 axis{solver.eigenvectors()(0, from), solver.eigenvectors()(1, from),
                        solver.eigenvectors()(2, from)};
        // Its largest coordinate is positive, so that one line has one axis.
        int largest = 0;
        for (int k = 1; k < 3; ++k)
            if (std::abs(axis[k]) > std::abs(axis[largest]) + at_rest) largest = k;
        found.axes[to] = axis[largest] < 0 ? -axis : axis;
    }
}

}  // namespace

std::optional<Moments> moments(const Rifs& rifs, const std::vector<double>& weights) {
    const auto shares = probabilities(rifs, weights);
    std::vector<Mean> means(rifs.follow_sets.size());
    std::size_t steps = 1;  // of a round
    for (const FollowSet& set : rifs.follow_sets) steps += set.maps.size();
    const std::size_t rounds = std::min(most_rounds, most_steps / steps);
    bool rests = false;
    for (std::size_t round = 0; round < rounds && !rests; ++round) {
        std::vector<Mean> next = applied(rifs, shares, means);
        double far = 0, size = 0;
        for (std::size_t s = 0; s < means.size(); ++s) {
            far = std::max(far, difference(next[s], means[s]));
            size = std::max(size, difference(next[s], Mean{}));
        }
        rests = far <= at_rest * size;
        means = std::move(next);
    }
    const Mean& start = means[static_cast<std::size_t>(rifs.start)];
    if (!rests || !std::isfinite(difference(start, Mean{}))) return std::nullopt;
    Moments found;
    found.centroid = start.first;
    found.covariance = start.second - glm::outerProduct(start.first, start.first);
    add_axes(found);
    add_errors(rifs, shares, means, found);
    return found;
}

}  // namespace pxm::host
