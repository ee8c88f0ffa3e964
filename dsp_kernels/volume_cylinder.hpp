// Bounding cylinders, and cylinders as objects: the unit cylinder about the y axis, radius 1 and
// -1 <= y <= 1, enlarged by `radius` about `center`. Node code: no allocation, no exceptions.
#pragma once

#include <optional>

#include "dsp_kernels/scene_block.hpp"
#include "dsp_kernels/volume_slab.hpp"

namespace pxm::kernels {

/// The part of a line within `radius` of the y axis. It is measured from the line's closest
/// approach to the axis.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] std::optional<Interval<Real>> within_mantle(Node& node, const Vec3<Real>& o,
                                                          const Vec3<Real>& d,
                                                          Real radius) noexcept {
    node.tally(Operation::multiply_add, 2);
    node.tally(Operation::compare_branch, 2);
    const Real across2 = d.x * d.x + d.z * d.z;
    const bool parallel = !(Real(0) < across2);
    Real closest = Real(0);
    if (!parallel) {
        node.tally(Operation::divide, 1);
        node.tally(Operation::multiply_add, 2);
        closest = -(o.x * d.x + o.z * d.z) / across2;
    }
    node.tally(Operation::multiply_add, 6);
    const Real x = o.x + closest * d.x;
    const Real z = o.z + closest * d.z;
    const Real half_chord2 = radius * radius - (x * x + z * z);
    if (half_chord2 < Real(0)) return {};
    if (parallel) return Interval<Real>{-far_away<Real>, far_away<Real>};
    node.tally(Operation::divide, 1);
    node.tally(Operation::square_root, 1);
    node.tally(Operation::multiply_add, 2);
    const Real half = square_root(half_chord2 / across2);
    return Interval<Real>{closest - half, closest + half};
}

/// A cylinder. Precondition: the ray was re-based to its centre.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] std::optional<Interval<Real>> intersect_cylinder(Node& node, const Ray<Real>& ray,
                                                               std::uint32_t follow_set) noexcept {
    using FollowSet = FollowSetRecord<real_words<Real>>;
    node.tally(Operation::call, 1);
    const Vec3<Real> o =
        subtract(node, ray.origin, read_vector(node, follow_set + FollowSet::center));
    const Real radius = node.shape_real(follow_set + FollowSet::radius);
    auto inside = within_mantle(node, o, ray.direction, radius);
    if (!inside) return {};
    if (!clip_to_slab(node, o.y, ray.direction.y, -radius, radius, *inside)) return {};
    node.tally(Operation::multiply_add, 2);
    return Interval<Real>{ray.base + inside->entry, ray.base + inside->exit};
}

/// The outward normal of the end or the mantle through which the ray enters or leaves.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Vec3<Real> cylinder_normal(Node& node, const Ray<Real>& ray, Side side,
                                         std::uint32_t follow_set) noexcept {
    using FollowSet = FollowSetRecord<real_words<Real>>;
    const Vec3<Real> o =
        subtract(node, ray.origin, read_vector(node, follow_set + FollowSet::center));
    const Vec3<Real>& d = ray.direction;
    const Real radius = node.shape_real(follow_set + FollowSet::radius);
    const auto mantle = within_mantle(node, o, d, radius);
    const bool entry = side == Side::entry;
    Real t = least_decisive<Real>(side);
    if (mantle) t = entry ? mantle->entry : mantle->exit;
    const int end = decisive_face(node, side, o.y, d.y, -radius, radius, t);
    if (end != 0) return {Real(0), Real(end), Real(0)};
    const Vec3<Real> point = add_scaled(node, o, t, d);
    return {point.x, Real(0), point.z};
}

}  // namespace pxm::kernels
