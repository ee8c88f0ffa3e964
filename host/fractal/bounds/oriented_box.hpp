// A box in axes of its own: for sets that are flat or long askew to the coordinates.
#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "host/fractal/bounds/inner_points.hpp"

namespace pxm::host {

/// The points center + sum of t_i half[i], |t_i| <= 1. The half axes are perpendicular.
struct OrientedBox {
    glm::dvec3 center{0.0};            // the middle
    std::array<glm::dvec3, 3> half{};  // half axes
};

/// How far the box reaches in direction u.
[[nodiscard]] double support(const OrientedBox& box, const glm::dvec3& u);

/// The principal axes of points, as the columns of a rotation, longest first.
[[nodiscard]] glm::dmat3 principal_axes(const Points& points);

/// The box along `axes` (columns of a rotation) that ends at low and high, measured along the axes.
[[nodiscard]] OrientedBox oriented_box(const glm::dmat3& axes, const glm::dvec3& low,
                                       const glm::dvec3& high);

/// By how much, along each axis of space, points may lie outside of that box although none is below
/// low or above high along `axes` and none has coordinates beyond `places`: axes are a rotation up
/// to rounding, and so is the box what it should be.
[[nodiscard]] double shortfall_along(const glm::dmat3& axes, const glm::dvec3& low,
                                     const glm::dvec3& high, const glm::dvec3& places);

}  // namespace pxm::host
