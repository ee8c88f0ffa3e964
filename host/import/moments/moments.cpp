#include "host/import/moments/moments.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

namespace pxm::host {
namespace {

/// A polynomial in x and y: coefficients in the order of PlaneMoments.
using Polynomial = std::vector<double>;

/// p (u x + v y + w), p of that degree.
Polynomial times(const Polynomial& p, int degree, double u, double v, double w) {
    Polynomial product(moment_count(degree + 1), 0.0);
    for (int n = 0; n <= degree; ++n) {
        for (int j = 0; j <= n; ++j) {
            const int i = n - j;
            const double c = p[moment_index(i, j)];
            product[moment_index(i + 1, j)] += u * c;
            product[moment_index(i, j + 1)] += v * c;
            product[moment_index(i, j)] += w * c;
        }
    }
    return product;
}

/// The polynomials x'^i y'^j of degree n, from those of degree n - 1, in the order of PlaneMoments.
std::vector<Polynomial> next_powers(const std::vector<Polynomial>& powers, int n,
                                    const PlaneMap& w) {
    std::vector<Polynomial> next;
    for (const Polynomial& p : powers) next.push_back(times(p, n - 1, w.a, w.b, w.e));
    next.push_back(times(powers.back(), n - 1, w.c, w.d, w.f));
    return next;
}

}  // namespace

double PlaneMap::lipschitz() const {
    const double squares = a * a + b * b + c * c + d * d;
    const double det = determinant();
    return std::sqrt((squares + std::sqrt(std::max(0.0, squares * squares - 4 * det * det))) / 2);
}

PlaneMoments moments_of(std::span<const WeightedPoint> points, int order) {
    PlaneMoments g(moment_count(order), 0.0);
    for (const WeightedPoint& p : points) {
        double column = p.weight;  // weight x^i
        for (int i = 0; i <= order; ++i, column *= p.x) {
            double term = column;
            for (int j = 0; i + j <= order; ++j, term *= p.y) g[moment_index(i, j)] += term;
        }
    }
    const double mass = g[0];
    for (double& moment : g) moment /= mass;  // Def. 10.1: g_00 = 1
    return g;
}

std::vector<double> determinant_weights(std::span<const PlaneMap> maps) {
    constexpr double starved = 1e-6;
    std::vector<double> weights;
    double sum = 0;
    for (const PlaneMap& map : maps) {
        weights.push_back(std::abs(map.determinant()) + starved);
        sum += weights.back();
    }
    for (double& weight : weights) weight /= sum;
    return weights;
}

PlaneMoments invariant_moments(std::span<const PlaneMap> maps, std::span<const double> weights,
                               int order) {
    PlaneMoments g(moment_count(order), 0.0);
    g[0] = 1;
    std::vector<std::vector<Polynomial>> powers(maps.size(), {Polynomial{1.0}});
    for (int n = 1; n <= order; ++n) {
        // g_n = M g_n + r: the moments of one degree depend on each other and on lower ones
        // (Eq. 10.3 with affine maps).
        Eigen::MatrixXd system = Eigen::MatrixXd::Identity(n + 1, n + 1);
        Eigen::VectorXd lower = Eigen::VectorXd::Zero(n + 1);
        const std::size_t below = moment_count(n - 1);
        for (std::size_t k = 0; k < maps.size(); ++k) {
            powers[k] = next_powers(powers[k], n, maps[k]);
            for (int row = 0; row <= n; ++row) {
                const Polynomial& p = powers[k][static_cast<std::size_t>(row)];
                for (std::size_t m = 0; m < below; ++m) lower(row) += weights[k] * p[m] * g[m];
                for (int column = 0; column <= n; ++column)
                    system(row, column) -= weights[k] * p[below + static_cast<std::size_t>(column)];
            }
        }
        const Eigen::VectorXd solved = system.partialPivLu().solve(lower);
        for (int j = 0; j <= n; ++j) g[moment_index(n - j, j)] = solved(j);
    }
    return g;
}

}  // namespace pxm::host
