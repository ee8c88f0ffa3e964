// Points that belong to the attractor: what bounds are measured against. Per follow set, the points
// that lie farthest in each of 26 directions, of those found; they start as fixed points of maps.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "host/fractal/system/rifs.hpp"

namespace pxm::host {

using Points = std::vector<glm::dvec3>;  // of one attractor

/// At least one and at most 26 points of each E_s. Precondition: the system contracts.
[[nodiscard]] std::vector<Points> inner_points(const Rifs& rifs);

/// One point of each E_s. Precondition: the system contracts.
[[nodiscard]] Points inner_point_of_each(const Rifs& rifs);

/// Those of the points that lie farthest in one of the 26 directions.
[[nodiscard]] Points extremes_of(const Points& points);

/// The point where `map` stands still. Precondition: I - T is regular, as it is if powers of T
/// vanish.
[[nodiscard]] glm::dvec3 fixed_point(const Affine& map);

/// The point of `points` that is farthest in direction u. Precondition: there is one.
[[nodiscard]] const glm::dvec3& extreme(const Points& points, const glm::dvec3& u);

}  // namespace pxm::host
