// Bounding boxes in axes of their own: for sets that are long or flat askew to the coordinates.
// Node code: no allocation, no exceptions.
#pragma once

#include <optional>

#include "dsp_kernels/scene_block.hpp"
#include "dsp_kernels/volume_slab.hpp"

namespace pxm::kernels {

/// A ray in the box's own coordinates: its centre is the origin, its faces lie at -1 and 1.
template <class Real>
struct BoxRay {
    Vec3<Real> origin;     // where t = base
    Vec3<Real> direction;  // for a unit of t
};

/// How far v reaches along each of the three axes, in half lengths of the box.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Vec3<Real> along_axes(Node& node, const Vec3<Real>& v,
                                    const Linear<Real>& axes) noexcept {
    return {dot(node, v, axes.rows[0]), dot(node, v, axes.rows[1]), dot(node, v, axes.rows[2])};
}

/// The ray in the coordinates of a follow set's box.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] BoxRay<Real> to_oriented_box(Node& node, const Ray<Real>& ray,
                                           std::uint32_t follow_set) noexcept {
    using FollowSet = FollowSetRecord<real_words<Real>>;
    using Oriented = OrientedRecord<real_words<Real>>;
    node.tally(Operation::integer, 1);
    const Vec3<Real> from_center =
        subtract(node, ray.origin, read_vector(node, follow_set + FollowSet::center));
    const std::uint32_t axes = node.shape_word(follow_set + FollowSet::shape) + Oriented::axes;
    const Linear<Real> rows = read_linear(node, axes);
    return {along_axes(node, from_center, rows), along_axes(node, ray.direction, rows)};
}

/// A box in its own axes. Precondition: the ray was re-based to its centre.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] std::optional<Interval<Real>> intersect_oriented(Node& node, const Ray<Real>& ray,
                                                               std::uint32_t follow_set) noexcept {
    node.tally(Operation::call, 1);
    const auto [o, d] = to_oriented_box(node, ray, follow_set);
    Interval<Real> inside{-far_away<Real>, far_away<Real>};
    if (!clip_to_slab(node, o.x, d.x, Real(-1), Real(1), inside)) return {};
    if (!clip_to_slab(node, o.y, d.y, Real(-1), Real(1), inside)) return {};
    if (!clip_to_slab(node, o.z, d.z, Real(-1), Real(1), inside)) return {};
    node.tally(Operation::multiply_add, 2);
    return Interval<Real>{ray.base + inside.entry, ray.base + inside.exit};
}

/// The outward normal of the face through which the ray enters or leaves.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Vec3<Real> oriented_normal(Node& node, const Ray<Real>& ray, Side side,
                                         std::uint32_t follow_set) noexcept {
    using FollowSet = FollowSetRecord<real_words<Real>>;
    using Oriented = OrientedRecord<real_words<Real>>;
    const auto [o, d] = to_oriented_box(node, ray, follow_set);
    const std::uint32_t axes = node.shape_word(follow_set + FollowSet::shape) + Oriented::axes;
    Vec3<Real> normal{};
    Real best = least_decisive<Real>(side);
    const auto take = [&](int sign, std::uint32_t axis) {
        if (sign == 0) return;
        normal = read_vector(node, axes + axis * 3 * real_words<Real>);
        if (sign < 0) normal = negate(normal);
    };
    take(decisive_face(node, side, o.x, d.x, Real(-1), Real(1), best), 0);
    take(decisive_face(node, side, o.y, d.y, Real(-1), Real(1), best), 1);
    take(decisive_face(node, side, o.z, d.z, Real(-1), Real(1), best), 2);
    return normal;
}

}  // namespace pxm::kernels
