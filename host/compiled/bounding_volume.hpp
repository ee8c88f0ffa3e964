// Bounding volumes as the nodes have them, made from what mathematics or a scene says of them.
#pragma once

#include "host/compiled/compiled_scene.hpp"
#include "host/fractal/bounds/bounds.hpp"
#include "host/fractal/bounds/oriented_box.hpp"
#include "host/fractal/bounds/polytope.hpp"

namespace pxm::host {

[[nodiscard]] CompiledVolume sphere_volume(const glm::dvec3& center, double radius);
[[nodiscard]] CompiledVolume box_volume(const glm::dvec3& low, const glm::dvec3& high);
/// Precondition: no half edge is zero.
[[nodiscard]] CompiledVolume oriented_volume(const OrientedBox& box);
/// Precondition: the polytope is bounded and `center` is near it.
[[nodiscard]] CompiledVolume hull_volume(const Polytope& polytope, const glm::dvec3& center);
/// The unit cone and the unit cylinder (docs/scene-language.md, "object").
[[nodiscard]] CompiledVolume cone_volume();
[[nodiscard]] CompiledVolume cylinder_volume();

/// The volume in other coordinates: x' = (x - origin) / scale.
[[nodiscard]] CompiledVolume in_frame(const CompiledVolume& volume, const glm::dvec3& origin,
                                      double scale);

/// A ball around a volume that a scene can declare, the smallest one. Precondition: not a hull and
/// not oriented.
[[nodiscard]] Ball ball_around(const CompiledVolume& volume);

}  // namespace pxm::host
