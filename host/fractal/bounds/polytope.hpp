// Convex volumes tighter than balls and boxes: an intersection of a few half-spaces around E_s
// (`hull` in the scene language), and the box along the set's own axes (`oriented`).
// Half-spaces come from the support function, so they contain E_s whatever the normals; normals are
// those of the hull of known points where that has few faces, as it has for homotheties of one
// ratio.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "host/fractal/bounds/approximation.hpp"

namespace pxm::host {

/// The points x with normal . x <= offset.
struct HalfSpace {
    glm::dvec3 normal;  // unit
    double offset = 0;  // in the units of the set
    bool operator==(const HalfSpace&) const = default;
};

using Polytope = std::vector<HalfSpace>;  // the points that lie in all of them

inline constexpr int most_half_spaces = 32;  // docs/scene-language.md, "object"

/// A bounded polytope that contains E_set, of at most most_half_spaces. `known` as from
/// approximation(); its bounds are finite.
[[nodiscard]] Polytope polytope(const Rifs& rifs, const Approximation& known, int set);

/// The corners of a bounded polytope. Where planes all but agree, points beside a corner may be
/// among them.
[[nodiscard]] std::vector<glm::dvec3> corners(const Polytope& polytope);

/// The largest distance of two points of a bounded polytope.
[[nodiscard]] double diameter(const Polytope& polytope);

/// A box that contains E_set, along its principal axes or along the coordinate axes, the smaller
/// one.
[[nodiscard]] OrientedBox oriented_box(const Rifs& rifs, const Approximation& known, int set);

}  // namespace pxm::host
