#include "host/fractal/dimension/conformal.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace pxm::host {

namespace {

constexpr int rounds = 2000;
constexpr int work_limit = 200'000;  // maps applied
constexpr double settled = 1e-15;
constexpr double wrong = 1e-11;  // of the form: what an image may differ from a multiple of it
constexpr double largest_condition = 1e6;

/// x -> T x in column vectors: glm's column i, the thesis' row i, is Eigen's column i.
Eigen::MatrixXd linear_part(const Affine& map, int n) {
    Eigen::MatrixXd t(n, n);
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) t(j, i) = map.linear[i][j];
    }
    return t;
}

/// |T x|^2 in the norm of `form`, as a form of x, with the factor of a similitude taken out.
Eigen::MatrixXd pulled_back(const Eigen::MatrixXd& form, const Eigen::MatrixXd& t, double factor) {
    return t.transpose() * form * t / factor;
}

/// The mean of a form over all words, if it has one: half of it stays each round, so that turns do
/// not make it swing.
Eigen::MatrixXd invariant_form(const std::vector<Eigen::MatrixXd>& maps,
                               const std::vector<double>& factors) {
    const Eigen::Index n = maps.front().rows();
    Eigen::MatrixXd form = Eigen::MatrixXd::Identity(n, n);
    const int affordable = std::max(20, work_limit / static_cast<int>(maps.size()));
    for (int round = 0; round < std::min(rounds, affordable); ++round) {
        Eigen::MatrixXd mean = Eigen::MatrixXd::Zero(n, n);
        for (std::size_t m = 0; m < maps.size(); ++m) {
            mean += pulled_back(form, maps[m], factors[m]) / static_cast<double>(maps.size());
        }
        Eigen::MatrixXd next = (form + mean) / 2;
        next *= static_cast<double>(n) / next.trace();
        next = (next + next.transpose()).eval() / 2;
        const double change = (next - form).norm();
        form = next;
        if (!(change > settled)) break;
    }
    return form;
}

/// Only maps whose eigenvalues have one modulus are similitudes anywhere.
bool may_be_similitude(const Eigen::MatrixXd& t, double ratio) {
    constexpr double nearly = 1e-6;
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(t, /*computeEigenvectors=*/false);
    if (solver.info() != Eigen::Success) return false;
    const Eigen::VectorXd moduli = solver.eigenvalues().cwiseAbs();
    return moduli.maxCoeff() < (1 + nearly) * ratio && moduli.minCoeff() > (1 - nearly) * ratio;
}

double condition(const Eigen::MatrixXd& form) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(form, Eigen::EigenvaluesOnly);
    if (solver.info() != Eigen::Success) return largest_condition * 2;
    const double least = solver.eigenvalues().minCoeff();
    return least > 0 ? solver.eigenvalues().maxCoeff() / least : largest_condition * 2;
}

}  // namespace

std::optional<ConformalRatios> conformal_ratios(const Rifs& rifs, int n) {
    std::vector<Eigen::MatrixXd> maps;
    std::vector<double> factors;  // squares of the ratios
    ConformalRatios result;
    for (const Affine& map : rifs.maps) {
        maps.push_back(linear_part(map, n));
        const double volume = std::abs(maps.back().determinant());
        if (!(volume > 0)) return std::nullopt;
        result.log_ratio.push_back(std::log(volume) / n);
        const double ratio = std::exp(result.log_ratio.back());
        if (!may_be_similitude(maps.back(), ratio)) return std::nullopt;
        factors.push_back(ratio * ratio);
    }
    const Eigen::MatrixXd form = invariant_form(maps, factors);
    if (!form.allFinite()) return std::nullopt;
    const double stretched = condition(form);
    if (!(stretched < largest_condition)) return std::nullopt;
    for (std::size_t m = 0; m < maps.size(); ++m) {
        const double rest = (pulled_back(form, maps[m], factors[m]) - form).norm();
        if (!(rest < wrong)) return std::nullopt;
        result.error = std::max(result.error, rest * stretched);
    }
    result.error += 1e-14;
    return result;
}

}  // namespace pxm::host
