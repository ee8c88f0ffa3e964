// Bounding boxes with their edges along the axes (Sec. 12.4).
// Node code: no allocation, no exceptions.
#pragma once

#include <optional>

#include "dsp_kernels/scene_block.hpp"
#include "dsp_kernels/volume_slab.hpp"

namespace pxm::kernels {

/// A box with its edges along the axes.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] std::optional<Interval<Real>> intersect_box(Node& node, const Ray<Real>& ray,
                                                          std::uint32_t follow_set) noexcept {
    using FollowSet = FollowSetRecord<real_words<Real>>;
    node.tally(Operation::call, 1);
    const Vec3<Real> low = read_vector(node, follow_set + FollowSet::low);
    const Vec3<Real> high = read_vector(node, follow_set + FollowSet::high);
    Interval<Real> inside{-far_away<Real>, far_away<Real>};
    if (!clip_to_slab(node, ray.origin.x, ray.direction.x, low.x, high.x, inside)) return {};
    if (!clip_to_slab(node, ray.origin.y, ray.direction.y, low.y, high.y, inside)) return {};
    if (!clip_to_slab(node, ray.origin.z, ray.direction.z, low.z, high.z, inside)) return {};
    node.tally(Operation::multiply_add, 2);
    return Interval<Real>{ray.base + inside.entry, ray.base + inside.exit};
}

/// The outward normal of the box face through which the ray enters or leaves: of the slabs' entries
/// the last, of their exits the first.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Vec3<Real> box_normal(Node& node, const Ray<Real>& ray, Side side,
                                    std::uint32_t follow_set) noexcept {
    using FollowSet = FollowSetRecord<real_words<Real>>;
    const Vec3<Real> low = read_vector(node, follow_set + FollowSet::low);
    const Vec3<Real> high = read_vector(node, follow_set + FollowSet::high);
    const Vec3<Real>& o = ray.origin;
    const Vec3<Real>& d = ray.direction;
    Vec3<Real> normal{};
    Real best = least_decisive<Real>(side);
    const auto take = [&](int sign, const Vec3<Real>& axis) {
        if (sign != 0) normal = sign < 0 ? negate(axis) : axis;
    };
    take(decisive_face(node, side, o.x, d.x, low.x, high.x, best), {Real(1), Real(0), Real(0)});
    take(decisive_face(node, side, o.y, d.y, low.y, high.y, best), {Real(0), Real(1), Real(0)});
    take(decisive_face(node, side, o.z, d.z, low.z, high.z, best), {Real(0), Real(0), Real(1)});
    return normal;
}

}  // namespace pxm::kernels
