// Between glm and Eigen: glm's column i, the thesis' row i of a linear part, is Eigen's column i,
// so that M x is the thesis' x T on both sides.
#pragma once

#include <Eigen/Core>
#include <glm/mat3x3.hpp>

namespace pxm::host {

[[nodiscard]] inline Eigen::Matrix3d eigen_matrix(const glm::dmat3& matrix) {
    Eigen::Matrix3d result;
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) result(row, column) = matrix[column][row];
    }
    return result;
}

[[nodiscard]] inline glm::dmat3 glm_matrix(const Eigen::Matrix3d& matrix) {
    glm::dmat3 result;
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) result[column][row] = matrix(row, column);
    }
    return result;
}

}  // namespace pxm::host
