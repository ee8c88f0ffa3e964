// A ray (Def. 12.2) and the interval of it that lies in a volume.
// Node code: no allocation, no exceptions.
#pragma once

#include "dsp_kernels/affine.hpp"

namespace pxm::kernels {

/// Farther than anything in a scene, in scene units.
template <class Real>
inline constexpr Real far_away = from_double<Real>(1e30);

/// The points origin + (t - base) direction. In the world the direction is a unit vector, so t is a
/// distance; affine maps keep t (Eq. 12.5). `base` moves with the origin when a ray is re-based
/// near a cell: small numbers near the cell keep the digits that a far origin would lose.
template <class Real>
struct Ray {
    Vec3<Real> origin;     // the point at t = base
    Vec3<Real> direction;  // for a unit of t
    Real base{};           // of the parameter
};

/// Part of a ray, from entry to exit; empty if exit < entry.
template <class Real>
struct Interval {
    Real entry;  // the parameter where it begins
    Real exit;   // the parameter where it ends
};

/// The point at parameter t.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Vec3<Real> point_at(Node& node, const Ray<Real>& ray, Real t) noexcept {
    node.tally(Operation::multiply_add, 1);
    return add_scaled(node, ray.origin, t - ray.base, ray.direction);
}

/// The ray in the coordinates of a master object: R(o M^-1, d M^-1), Eq. 12.3.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Ray<Real> transform_ray(Node& node, const Ray<Real>& ray,
                                      const AffineMap<Real>& inverse) noexcept {
    return {transform_point(node, ray.origin, inverse),
            transform_direction(node, ray.direction, inverse.linear), ray.base};
}

/// The same ray with its origin at the closest approach to `center`.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Ray<Real> rebase(Node& node, const Ray<Real>& ray,
                               const Vec3<Real>& center) noexcept {
    const Vec3<Real> to_center = subtract(node, center, ray.origin);
    const Real along = dot(node, to_center, ray.direction);
    const Real length2 = dot(node, ray.direction, ray.direction);
    node.tally(Operation::divide, 1);
    node.tally(Operation::multiply_add, 1);
    const Real step = along / length2;
    return {add_scaled(node, ray.origin, step, ray.direction), ray.direction, ray.base + step};
}

}  // namespace pxm::kernels
