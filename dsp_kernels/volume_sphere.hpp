// Bounding spheres: where a ray enters and leaves them, and their normals there (Sec. 12.4).
// Node code: no allocation, no exceptions.
#pragma once

#include <optional>

#include "dsp_kernels/ray.hpp"
#include "dsp_kernels/scene_block.hpp"

namespace pxm::kernels {

/// A sphere, for a ray that was re-based to its centre: what is left of (origin - centre) is the
/// perpendicular from the centre to the ray.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] std::optional<Interval<Real>> intersect_sphere(Node& node, const Ray<Real>& ray,
                                                             std::uint32_t follow_set) noexcept {
    using FollowSet = FollowSetRecord<real_words<Real>>;
    node.tally(Operation::call, 1);
    const Vec3<Real> center = read_vector(node, follow_set + FollowSet::center);
    const Real radius = node.shape_real(follow_set + FollowSet::radius);
    const Vec3<Real> perpendicular = subtract(node, ray.origin, center);
    const Real miss2 = dot(node, perpendicular, perpendicular);
    node.tally(Operation::multiply_add, 2);
    node.tally(Operation::compare_branch, 1);
    const Real half_chord2 = radius * radius - miss2;
    if (half_chord2 < Real(0)) return std::nullopt;
    const Real length2 = dot(node, ray.direction, ray.direction);
    node.tally(Operation::divide, 1);
    node.tally(Operation::square_root, 1);
    node.tally(Operation::multiply_add, 2);
    const Real half = square_root(half_chord2 / length2);
    return Interval<Real>{ray.base - half, ray.base + half};
}

/// The outward normal of a sphere where the ray has parameter t, of any length.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Vec3<Real> sphere_normal(Node& node, const Ray<Real>& ray, Real t,
                                       std::uint32_t follow_set) noexcept {
    using FollowSet = FollowSetRecord<real_words<Real>>;
    node.tally(Operation::multiply_add, 1);
    const Vec3<Real> point = add_scaled(node, ray.origin, t - ray.base, ray.direction);
    return subtract(node, point, read_vector(node, follow_set + FollowSet::center));
}

}  // namespace pxm::kernels
