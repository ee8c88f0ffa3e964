// What a pixel covers of a plane: an ellipse, as wide as the pixel's size p (Ch. 15) and, along the
// view, p over the cosine long. A long one is looked at in several spots along it, so that a floor
// neither aliases nor blurs towards the horizon. Node code: no allocation, no exceptions.
#pragma once

#include "dsp_kernels/ray.hpp"

namespace pxm::kernels {

inline constexpr int most_spots = 16;  // of one ellipse; beyond, spots grow long themselves

/// A point or a direction on a plane, in repeats of a texture.
template <class Real>
struct Vec2 {
    Real u{};  // along the first axis
    Real v{};  // along the second
};

/// An ellipse on a plane: its full axes, and how many spots it is looked at in.
template <class Real>
struct Footprint {
    Vec3<Real> minor;  // the shorter one
    Vec3<Real> major;  // the longer one
    int spots = 1;     // along the longer one, up to most_spots
};

/// Where a texture is looked at: a point, and the full axes of an ellipse about it.
template <class Real>
struct Spot {
    Vec2<Real> at;     // its middle
    Vec2<Real> minor;  // the shorter full axis
    Vec2<Real> major;  // the longer full axis
};

/// The vector product.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Vec3<Real> cross(Node& node, const Vec3<Real>& a, const Vec3<Real>& b) noexcept {
    node.tally(Operation::multiply_add, 6);
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// A vector of the plane with that unit normal, not null.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Vec3<Real> vector_in_plane(Node& node, const Vec3<Real>& normal) noexcept {
    constexpr Real half = from_double<Real>(0.5);
    node.tally(Operation::compare_branch, 1);
    Vec3<Real> axis{};
    (absolute(normal.x) < half ? axis.x : axis.y) = Real(1);
    return cross(node, normal, axis);
}

/// The footprint of a pixel of size p where a ray with that unit direction meets a plane.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Footprint<Real> footprint(Node& node, const Vec3<Real>& direction,
                                        const Vec3<Real>& normal, Real p) noexcept {
    constexpr Real least_cosine = from_double<Real>(1.0 / 1024);
    constexpr Real least_sine2 = from_double<Real>(0x1p-16);  // less has no digits left
    node.tally(Operation::call, 1);
    node.tally(Operation::select, 2);
    const Real into = dot(node, direction, normal);
    Real cosine = absolute(into);
    if (cosine < least_cosine) cosine = least_cosine;
    Vec3<Real> along = add_scaled(node, direction, -into, normal);
    node.tally(Operation::compare_branch, 1);
    if (!(least_sine2 < dot(node, along, along))) along = vector_in_plane(node, normal);
    along = normalize(node, along);
    node.tally(Operation::reciprocal, 1);
    node.tally(Operation::multiply_add, 1);
    node.tally(Operation::to_float, 1);
    const Real stretch = reciprocal(cosine);
    const int spots = nearest_integer(stretch);
    return {scale(node, p, cross(node, normal, along)), scale(node, p * stretch, along),
            spots < most_spots ? spots : most_spots};
}

/// A direction of the world in repeats.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Vec2<Real> in_repeats(Node& node, const Vec3<Real>& d, const Vec3<Real>& across,
                                    const Vec3<Real>& along) noexcept {
    return {dot(node, d, across), dot(node, d, along)};
}

/// A coordinate in repeats: which repeat, and the place in it from 0 to 1.
template <class Real>
struct Place {
    Real fraction;         // 0 to 1
    std::uint32_t repeat;  // its number, modulo repeat_period
};

inline constexpr double farthest_repeat = 0x1p20;  // beyond, a fraction has too few digits
inline constexpr double repeat_period = 0x1p14;    // whole parts of a node have 16 bits

/// Splits a coordinate. Precondition: it is less than farthest_repeat.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Place<Real> place_of(Node& node, Real x) noexcept {
    constexpr Real period = from_double<Real>(repeat_period);
    constexpr Real per_period = from_double<Real>(1 / repeat_period);
    node.tally(Operation::compare_branch, 2);
    node.tally(Operation::to_float, 1);
    node.tally(Operation::multiply_add, 1);
    if (!(absolute(x) < period)) {
        node.tally(Operation::to_float, 1);
        node.tally(Operation::multiply_add, 2);
        x = x - period * from_double<Real>(floor_integer(x * per_period));
    }
    const int whole = floor_integer(x);
    const Real fraction = x - from_double<Real>(whole);
    // A tiny negative x is rounded up to a whole one.
    if (!(fraction < Real(1))) return {Real(0), static_cast<std::uint32_t>(whole) + 1};
    return {fraction, static_cast<std::uint32_t>(whole)};
}

}  // namespace pxm::kernels
