// A cell's matrix as a turn and a stretch along the shape's axes.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace pxm::host {

struct TurnAndStretch {
    glm::dvec4 quaternion{0, 0, 0, 1};  // x y z w
    glm::dvec3 stretch{1.0};            // all negative if the matrix mirrors
};

/// Precondition: the matrix' columns are perpendicular.
[[nodiscard]] TurnAndStretch turn_and_stretch(const glm::dmat3& matrix);

}  // namespace pxm::host
