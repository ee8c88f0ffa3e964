// Real moments of measures in the plane and of invariant measures of affine IFSs (Sec. 10.1,
// Eq. 10.1 and, for affine maps, Eq. 10.3). Complex moments do not determine a set (Erratum 17).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace pxm::host {

/// x' = a x + b y + e, y' = c x + d y + f
struct PlaneMap {
    double a = 0, b = 0, c = 0, d = 0, e = 0, f = 0;

    [[nodiscard]] double determinant() const { return a * d - b * c; }
    /// The larger singular value.
    [[nodiscard]] double lipschitz() const;
};

struct WeightedPoint {
    double x = 0, y = 0, weight = 1;
};

/// Moments g_ij with i + j <= order, by rising degree, g_d0 before g_0d.
using PlaneMoments = std::vector<double>;

[[nodiscard]] constexpr std::size_t moment_count(int order) {
    return static_cast<std::size_t>((order + 1) * (order + 2) / 2);
}
[[nodiscard]] constexpr std::size_t moment_index(int i, int j) {
    return moment_count(i + j) - static_cast<std::size_t>(i) - 1;
}

/// Moments of the points as a measure of mass 1. Precondition: the weights' sum is positive.
[[nodiscard]] PlaneMoments moments_of(std::span<const WeightedPoint> points, int order);

/// Weights by |det| (Erratum 17), with a floor so that no map is starved; their sum is 1.
[[nodiscard]] std::vector<double> determinant_weights(std::span<const PlaneMap> maps);

/// Moments of the measure with mu = sum of weights[k] mu(w_k^-1). Precondition: the maps contract.
[[nodiscard]] PlaneMoments invariant_moments(std::span<const PlaneMap> maps,
                                             std::span<const double> weights, int order);

}  // namespace pxm::host
