#include "host/fractal/measure/moments.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

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
    return found;
}

}  // namespace pxm::host
