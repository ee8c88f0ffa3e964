// What is known of the attractor while it is being bounded: for each follow set, volumes that
// contain E_s and points that belong to it. Volumes are what double makes of them; what rounding
// took from each is carried beside it.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "host/fractal/bounds/bounds.hpp"
#include "host/fractal/bounds/inner_points.hpp"
#include "host/fractal/bounds/oriented_box.hpp"
#include "host/fractal/bounds/support_grid.hpp"
#include "host/math/rounding.hpp"

namespace pxm::host {

/// By how much E_s may stick out of its volumes, along each axis.
struct Shortfall {
    double ball = 0;      // in world units, as all three
    double box = 0;       // of the box along the axes
    double oriented = 0;  // of the oriented box
};

struct Approximation {                  // what is known of a system, per follow set
    std::vector<Bounds> outer;          // around each E_s
    std::vector<OrientedBox> oriented;  // around E_s as well
    std::vector<Points> inner;          // points of each E_s
    SupportGrid grid;                   // empty, or the support functions in many directions
    std::vector<Box> sure;              // as `outer`, every step rounded outward
    std::vector<Shortfall> shortfall;   // of the volumes in `outer` and `oriented`
};

/// How far E_set can reach in direction u: the least that its volumes allow, and what they may be
/// short by.
[[nodiscard]] Rounded volume_support(const Approximation& known, int set, const glm::dvec3& u);

/// No smaller than the coordinates of the points of E_set, in size.
[[nodiscard]] glm::dvec3 coordinates(const Approximation& known, int set);

/// What bounds and the system itself tell. Oriented boxes are the bounds' own boxes. Precondition:
/// the bounds contain each E_s, without a margin.
[[nodiscard]] Approximation approximation(const Rifs& rifs, const std::vector<Bounds>& bounds);

/// What bounds alone tell.
[[nodiscard]] Approximation approximation(const std::vector<Bounds>& bounds,
                                          std::vector<Points> inner);

/// The box as an oriented one, and what rounding may take from it.
[[nodiscard]] OrientedBox as_oriented(const Box& box);
[[nodiscard]] double shortfall_of_oriented(const Box& box);  // the same of as_oriented()'s box

}  // namespace pxm::host
