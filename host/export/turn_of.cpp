#include "host/export/turn_of.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace pxm::host {
namespace {

/// Of a rotation: the largest of the four is computed first, so that none is lost to rounding.
glm::dvec4 quaternion_of(const glm::dmat3& r) {
    const double trace = r[0][0] + r[1][1] + r[2][2];
    glm::dvec4 q{r[1][2] - r[2][1], r[2][0] - r[0][2], r[0][1] - r[1][0], 1 + trace};
    int largest = 3;
    double most = trace;
    for (int i = 0; i < 3; ++i)
        if (r[i][i] > most) {
            largest = i;
            most = r[i][i];
        }
    if (largest < 3) {
        const int i = largest, j = (i + 1) % 3, k = (i + 2) % 3;
        q[i] = 1 + r[i][i] - r[j][j] - r[k][k];
        q[j] = r[i][j] + r[j][i];
        q[k] = r[i][k] + r[k][i];
        q[3] = r[j][k] - r[k][j];
    }
    return glm::normalize(q);
}

}  // namespace

TurnAndStretch turn_and_stretch(const glm::dmat3& matrix) {
    TurnAndStretch result;
    const bool mirrors = glm::dot(matrix[0], glm::cross(matrix[1], matrix[2])) < 0;
    glm::dmat3 turn = matrix;
    for (int i = 0; i < 3; ++i) {
        const double length = std::max(glm::length(matrix[i]), std::numeric_limits<double>::min());
        result.stretch[i] = mirrors ? -length : length;
        turn[i] /= result.stretch[i];
    }
    result.quaternion = quaternion_of(turn);
    return result;
}

}  // namespace pxm::host
