#include "host/math/spectrum.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "host/math/eigen_matrix.hpp"

namespace pxm::host {

std::optional<double> spectral_radius(const glm::dmat3& matrix) {
    const Eigen::Matrix3d m = eigen_matrix(matrix);
    if (!m.allFinite()) return std::nullopt;
    const Eigen::EigenSolver<Eigen::Matrix3d> solver(m, /*computeEigenvectors=*/false);
    if (solver.info() != Eigen::Success) return std::nullopt;
    return solver.eigenvalues().cwiseAbs().maxCoeff();
}

std::optional<glm::dmat3> symmetric_axes(const glm::dmat3& matrix) {
    const Eigen::Matrix3d m = eigen_matrix(matrix);
    if (!m.allFinite()) return std::nullopt;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(m);
    if (solver.info() != Eigen::Success) return std::nullopt;
    return glm_matrix(solver.eigenvectors().rowwise().reverse());
}

std::optional<double> largest_ratio(const glm::dmat3& a, const glm::dmat3& b) {
    const Eigen::Matrix3d left = eigen_matrix(a);
    const Eigen::Matrix3d right = eigen_matrix(b);
    if (!left.allFinite() || !right.allFinite()) return std::nullopt;
    if (right.llt().info() != Eigen::Success) return std::nullopt;  // the solver does not ask
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix3d> solver(left, right,
                                                                           Eigen::EigenvaluesOnly);
    if (solver.info() != Eigen::Success) return std::nullopt;
    return solver.eigenvalues()(2);
}

std::optional<glm::dmat3> lower_root(const glm::dmat3& matrix) {
    const Eigen::Matrix3d m = eigen_matrix(matrix);
    const Eigen::LLT<Eigen::Matrix3d> factors(m);
    if (!m.allFinite() || factors.info() != Eigen::Success) return std::nullopt;
    return glm_matrix(factors.matrixL());
}

}  // namespace pxm::host
