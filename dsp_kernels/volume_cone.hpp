// Bounding cones, and cones as objects: the unit cone, base disc of radius 1 at y = 0 and apex
// (0,1,0), enlarged by `radius` about `center`, the centre of its base. Node code: no allocation,
// no exceptions.
#pragma once

#include <optional>

#include "dsp_kernels/scene_block.hpp"
#include "dsp_kernels/volume_slab.hpp"

namespace pxm::kernels {

/// Clips `interval` to the mantle's side of the cone, extended downward without end: the points
/// with x^2 + z^2 <= (r - y)^2 below the apex. Precondition: above the apex nothing is asked for,
/// as the interval ends there or the caller clips it. False if nothing is left.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] bool clip_to_mantle(Node& node, const Vec3<Real>& o, const Vec3<Real>& d, Real radius,
                                  Interval<Real>& interval) noexcept {
    node.tally(Operation::dot_product, 3);
    node.tally(Operation::multiply_add, 4);
    node.tally(Operation::compare_branch, 3);
    const Real zero = Real(0);
    const Real below = radius - o.y;
    // a t^2 + 2 b t + c <= 0
    const Real a = sum_of_products(d.x, d.x, d.z, d.z, -d.y, d.y);
    const Real b = sum_of_products(o.x, d.x, o.z, d.z, below, d.y);
    const Real c = sum_of_products(o.x, o.x, o.z, o.z, -below, below);
    const bool level = zero < a;  // less steep than the mantle: one nappe is crossed, in and out
    Real discriminant = b * b - a * c;
    if (discriminant < zero) {
        if (level) return false;
        discriminant = zero;  // a steep line crosses both nappes: rounding
    }
    node.tally(Operation::square_root, 1);
    const Real root = square_root(discriminant);
    const Real q = b < zero ? root - b : -(b + root);  // of the sums the one that does not cancel
    node.tally(Operation::compare_branch, 5);
    const bool along = !level && !(a < zero);  // parallel to the mantle: a single root
    const bool no_quotient = !(q < zero) && !(zero < q);
    if (along && no_quotient) return !(zero < c);
    node.tally(Operation::divide, 2);
    node.tally(Operation::select, 4);
    Real near = no_quotient ? zero : c / q;
    Real far = along ? near : q / a;
    if (far < near) {
        const Real swapped = far;
        far = near;
        near = swapped;
    }
    // A steep line is below the apex where it goes down to; one along the mantle has one inside
    // end.
    const bool ends_inside = along ? b < zero : d.y < zero;
    if (level) {
        if (interval.entry < near) interval.entry = near;
        if (far < interval.exit) interval.exit = far;
    } else if (ends_inside) {
        if (interval.entry < far) interval.entry = far;
    } else {
        if (near < interval.exit) interval.exit = near;
    }
    return !(interval.exit < interval.entry);
}

/// A cone. Precondition: the ray was re-based to the centre of its base.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] std::optional<Interval<Real>> intersect_cone(Node& node, const Ray<Real>& ray,
                                                           std::uint32_t follow_set) noexcept {
    using FollowSet = FollowSetRecord<real_words<Real>>;
    node.tally(Operation::call, 1);
    const Vec3<Real> o =
        subtract(node, ray.origin, read_vector(node, follow_set + FollowSet::center));
    const Real radius = node.shape_real(follow_set + FollowSet::radius);
    Interval<Real> inside{-far_away<Real>, far_away<Real>};
    if (!clip_to_slab(node, o.y, ray.direction.y, Real(0), radius, inside)) return {};
    if (!clip_to_mantle(node, o, ray.direction, radius, inside)) return {};
    node.tally(Operation::multiply_add, 2);
    return Interval<Real>{ray.base + inside.entry, ray.base + inside.exit};
}

/// The outward normal where the ray enters or leaves; at the apex it is upward.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Vec3<Real> cone_normal(Node& node, const Ray<Real>& ray, Side side,
                                     std::uint32_t follow_set) noexcept {
    using FollowSet = FollowSetRecord<real_words<Real>>;
    const Vec3<Real> o =
        subtract(node, ray.origin, read_vector(node, follow_set + FollowSet::center));
    const Vec3<Real>& d = ray.direction;
    const Real radius = node.shape_real(follow_set + FollowSet::radius);
    const bool entry = side == Side::entry;
    Interval<Real> mantle{-far_away<Real>, far_away<Real>};
    (void)clip_to_mantle(node, o, d, radius, mantle);
    node.tally(Operation::compare_branch, 3);
    const Real t = entry ? mantle.entry : mantle.exit;
    if (entry ? Real(0) < d.y : d.y < Real(0)) {
        node.tally(Operation::divide, 1);
        const Real at_base = -o.y / d.y;
        if (entry ? t < at_base : at_base < t) return {Real(0), Real(-1), Real(0)};
    }
    const Vec3<Real> point = add_scaled(node, o, t, d);
    node.tally(Operation::multiply_add, 1);
    const Vec3<Real> normal{point.x, radius - point.y, point.z};
    if (!(Real(0) < dot(node, normal, normal))) return {Real(0), Real(1), Real(0)};
    return normal;
}

}  // namespace pxm::kernels
