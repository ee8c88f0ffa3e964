#include "host/import/aifs/aifs_space.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>

namespace pxm::host {
namespace {

using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Complex = std::complex<double>;

constexpr double same_modulus = 1e-9;  // two moduli are equal up to here
constexpr double not_simple = 1e-6;    // eigenvalues that are nearer have no vectors of their own
constexpr double invariance = 1e-8;    // how exactly a map has to keep the subspace

struct EigenPair {
    Complex value;
    Eigen::VectorXcd vector;
};

/// A matrix' eigenvalues with Im >= 0 and the left eigenvectors, the largest modulus first, of
/// equal ones the largest real part.
std::vector<EigenPair> ordered_pairs(const RowMatrix& matrix, const Position& place) {
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(Eigen::MatrixXd(matrix.transpose()));
    if (solver.info() != Eigen::Success)
        throw AifsMistake{place, "$subspace: the eigenvalues could not be found"};
    const double scale = std::max(solver.eigenvalues().cwiseAbs().maxCoeff(), 1e-300);
    std::vector<EigenPair> pairs;
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
        Complex value = solver.eigenvalues()[i];
        if (std::abs(value.imag()) <= same_modulus * scale) value = value.real();
        if (value.imag() >= 0) pairs.push_back({value, solver.eigenvectors().col(i)});
    }
    std::ranges::sort(pairs, [&](const EigenPair& a, const EigenPair& b) {
        const double difference = std::abs(a.value) - std::abs(b.value);
        if (std::abs(difference) > same_modulus * scale) return difference > 0;
        return a.value.real() > b.value.real();
    });
    for (std::size_t i = 1; i < pairs.size(); ++i)
        if (std::abs(pairs[i].value - pairs[i - 1].value) < not_simple * scale)
            throw AifsMistake{place,
                              "$subspace: an eigenvalue that comes twice has no subspace of "
                              "its own"};
    return pairs;
}

}  // namespace

AifsProjection::AifsProjection(const AifsSystem& system, const Position& place)
    : full_(system.dimension), shown_(system.dimension), place_(place) {
    const auto n = static_cast<Eigen::Index>(full_);
    RowMatrix rows = RowMatrix::Identity(n, n);
    if (system.subspace_of) {
        const RowMatrix matrix =
            Eigen::Map<const RowMatrix>(system.subspace_of->linear.data(), n, n);
        const std::vector<EigenPair> pairs = ordered_pairs(matrix, place);
        rows.resize(0, n);
        for (const int cell : system.cells) {
            if (static_cast<std::size_t>(cell) >= pairs.size())
                throw AifsMistake{place, fmt::format("$subspace: there is no part {}: the matrix "
                                                     "has {}",
                                                     cell, pairs.size())};
            const EigenPair& pair = pairs[static_cast<std::size_t>(cell)];
            // The first base vector lies at 1, so that the vector [c0, c1, ...] of a companion
            // matrix lies at c0 + c1 L + c2 L^2 ... for its eigenvalue L.
            Eigen::Index first = 0;
            if (std::abs(pair.vector[0]) < same_modulus) pair.vector.cwiseAbs().maxCoeff(&first);
            const Eigen::VectorXcd vector = pair.vector / pair.vector[first];
            rows.conservativeResize(rows.rows() + (pair.value.imag() > 0 ? 2 : 1), n);
            rows.row(rows.rows() - (pair.value.imag() > 0 ? 2 : 1)) = vector.real().transpose();
            if (pair.value.imag() > 0) rows.row(rows.rows() - 1) = vector.imag().transpose();
        }
    }
    if (rows.rows() > 3)
        throw AifsMistake{place, fmt::format("{} dimensions: $subspace has to name 1 to 3 to be "
                                             "shown",
                                             rows.rows())};
    shown_ = static_cast<std::size_t>(rows.rows());
    const RowMatrix back = rows.transpose() * (rows * rows.transpose()).inverse();
    if (!back.allFinite()) throw AifsMistake{place, "$subspace: a part that is named twice"};
    rows_.assign(rows.data(), rows.data() + rows.size());
    inverse_.assign(back.data(), back.data() + back.size());
}

AffineN AifsProjection::operator()(const AffineN& map) const {
    const auto n = static_cast<Eigen::Index>(full_);
    const auto k = static_cast<Eigen::Index>(shown_);
    const Eigen::Map<const RowMatrix> rows(rows_.data(), k, n);
    const Eigen::Map<const RowMatrix> back(inverse_.data(), n, k);
    const Eigen::Map<const RowMatrix> linear(map.linear.data(), n, n);
    const Eigen::Map<const Eigen::VectorXd> offset(map.offset.data(), n);
    if (!linear.allFinite() || !offset.allFinite())
        throw AifsMistake{place_, "a map that is not finite"};
    const RowMatrix moved = rows * linear;
    const RowMatrix shown = moved * back;
    const Eigen::VectorXd shift = rows * offset;
    if ((moved - shown * rows).cwiseAbs().maxCoeff() >
        invariance * std::max(moved.cwiseAbs().maxCoeff(), 1e-300))
        throw AifsMistake{place_,
                          "a map does not keep the subspace that is shown: what is seen of "
                          "it would depend on what is not"};
    return {{shown.data(), shown.data() + shown.size()}, {shift.data(), shift.data() + k}};
}

}  // namespace pxm::host
