// What is known of the attractor while it is being bounded: for each follow set, volumes that
// contain E_s and points that belong to it.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "host/fractal/bounds/bounds.hpp"
#include "host/fractal/bounds/inner_points.hpp"
#include "host/fractal/bounds/oriented_box.hpp"
#include "host/fractal/bounds/support_grid.hpp"

namespace pxm::host {

struct Approximation {
    std::vector<Bounds> outer;
    std::vector<OrientedBox> oriented;  // around E_s as well
    std::vector<Points> inner;
    SupportGrid grid;  // empty, or the support functions in many directions
};

/// How far E_set can reach in direction u: the least that its volumes allow.
[[nodiscard]] double volume_support(const Approximation& known, int set, const glm::dvec3& u);

/// What bounds and the system itself tell. Oriented boxes are the bounds' own boxes.
[[nodiscard]] Approximation approximation(const Rifs& rifs, const std::vector<Bounds>& bounds);

/// The box as an oriented one.
[[nodiscard]] OrientedBox as_oriented(const Box& box);

}  // namespace pxm::host
