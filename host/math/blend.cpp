#include "host/math/blend.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>

#include "host/math/eigen_matrix.hpp"
#include "host/math/lipschitz.hpp"

namespace pxm::host {

namespace {

/// M = turn stretch, the stretch symmetric: M = U S V^T = (U V^T) (V S V^T).
struct Polar {
    Eigen::Matrix3d turn;
    Eigen::Matrix3d log_stretch;  // V log(S) V^T
};

Polar polar(const glm::dmat3& linear) {
    const SingularValues found = singular_values(linear);
    Polar result{Eigen::Matrix3d::Zero(), Eigen::Matrix3d::Zero()};
    for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Vector3d in(found.input[i].x, found.input[i].y, found.input[i].z);
        const Eigen::Vector3d out(found.output[i].x, found.output[i].y, found.output[i].z);
        result.turn += out * in.transpose();
        result.log_stretch += std::log(found.values[i]) * in * in.transpose();
    }
    return result;
}

Eigen::Matrix3d exponential(const Eigen::Matrix3d& symmetric) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(symmetric);
    return solver.eigenvectors() * solver.eigenvalues().array().exp().matrix().asDiagonal() *
           solver.eigenvectors().transpose();
}

}  // namespace

std::variant<Affine, std::string> blend(const Affine& a, const Affine& b, double share) {
    constexpr double half_turn = 1e-6;  // cosine of half the angle between turns
    if (classify(a) == MapKind::singular || classify(b) == MapKind::singular)
        return "a map that squashes flat cannot be blended";
    const double mirror = determinant(a) < 0 ? -1 : 1;
    if ((determinant(b) < 0 ? -1 : 1) != mirror)
        return "one of the maps mirrors and the other does not: on the way they would be flat";
    if (share == 0) return a;
    if (share == 1) return b;
    const Polar from = polar(mirror * a.linear), to = polar(mirror * b.linear);
    const Eigen::Quaterniond first(from.turn), last(to.turn);
    if (std::abs(first.dot(last)) < half_turn)
        return "the maps are half a turn apart: put one between them that says which way to turn";
    const Eigen::Matrix3d turn = first.slerp(share, last).toRotationMatrix();
    const Eigen::Matrix3d stretch =
        exponential((1 - share) * from.log_stretch + share * to.log_stretch);
    Affine result;
    result.linear = mirror * glm_matrix(turn * stretch);
    result.translation = (1 - share) * a.translation + share * b.translation;
    return result;
}

}  // namespace pxm::host
