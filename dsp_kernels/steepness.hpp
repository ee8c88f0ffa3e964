// Steep cells: inside maps that squash very much in one direction. The inverse of such a map mixes
// what it stretches into all coordinates, and what it does to the others is lost among the digits;
// and the directions of rays grow with every level until their squares are out of range. Here the
// ray is brought to the cell along the stretched axis alone, and its direction is kept short. Node
// code: no allocation, no exceptions.
#pragma once

#include "dsp_kernels/cell.hpp"
#include "dsp_kernels/scene_block.hpp"

namespace pxm::kernels {

/// The sum of a direction's magnitudes is no larger in a cell: squares of it, and products with
/// what else is large near a thin cell, stay in range.
template <class Real>
inline constexpr Real longest_direction = from_double<Real>(0x1p50);
/// What is too long is multiplied with, again and again: a power of two, which changes no digit of
/// it. A ray is through a volume of diameter 1 within 2^-40 then, where p is 2^-20 at least:
/// whether it meets the cell is a matter of its course alone, and when is known from the cell
/// around it.
template <class Real>
inline constexpr Real shortening = from_double<Real>(0x1p-10);

inline constexpr int most_shortenings = 8;  // enough for all single numbers but infinity

/// |x| + |y| + |z|.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Real sum_of_magnitudes(Node& node, const Vec3<Real>& v) noexcept {
    node.tally(Operation::select, 3);
    node.tally(Operation::multiply_add, 2);
    return absolute(v.x) + absolute(v.y) + absolute(v.z);
}

/// The power of two that makes a length short enough; 1 if it is.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Real shortening_of(Node& node, Real length) noexcept {
    node.tally(Operation::compare_branch, 1);
    Real factor = Real(1);
    for (int i = 0; i < most_shortenings && longest_direction<Real> < length; ++i) {
        node.tally(Operation::loop_turn, 1);
        node.tally(Operation::multiply_add, 2);
        node.tally(Operation::compare_branch, 1);
        factor = factor * shortening<Real>;
        length = length * shortening<Real>;
    }
    return factor;
}

/// Makes a direction short enough to be squared.
template <NodeLike Node, class Real = typename Node::Real>
void shorten(Node& node, Vec3<Real>& direction) noexcept {
    direction = scale(node, shortening_of(node, sum_of_magnitudes(node, direction)), direction);
}

/// The same for the images of all directions together: normals that go through them keep theirs.
template <NodeLike Node, class Real = typename Node::Real>
void shorten(Node& node, Linear<Real>& linear) noexcept {
    node.tally(Operation::multiply_add, 2);
    Real length = Real(0);
    for (const Vec3<Real>& row : linear.rows) length = length + sum_of_magnitudes(node, row);
    const Real factor = shortening_of(node, length);
    for (Vec3<Real>& row : linear.rows) row = scale(node, factor, row);
}

/// The parent's ray in the child's coordinates, with its origin where it is as high as the child's
/// centre. There the height is that of the centre, and has no error that the stretch could have
/// made large; the other coordinates never had one. A ray that is not mainly stretched stays as the
/// whole inverse leaves it.
template <NodeLike Node, class Real = typename Node::Real>
void enter_along_axis(Node& node, const Ray<Real>& ray, std::uint32_t steep,
                      Cell<Real>& child) noexcept {
    using Steep = SteepRecord<real_words<Real>>;
    using FollowSet = FollowSetRecord<real_words<Real>>;
    const Vec3<Real> axis = read_vector(node, steep + Steep::axis);
    const AffineMap<Real> across = read_affine(node, steep + Steep::across);
    const Vec3<Real> drift = transform_direction(node, ray.direction, across.linear);
    const Real climb = dot(node, ray.direction, axis);
    node.tally(Operation::select, 1);
    node.tally(Operation::compare_branch, 1);
    if (!(sum_of_magnitudes(node, drift) < absolute(climb))) return;
    const Vec3<Real> up = read_vector(node, steep + Steep::up);
    const Vec3<Real> center = read_vector(node, child.follow_set + FollowSet::center);
    const Real height = dot(node, center, up);
    node.tally(Operation::multiply_add, 3);
    node.tally(Operation::divide, 1);
    const Real from = dot(node, ray.origin, axis) + node.shape_real(steep + Steep::height);
    const Real step = (height - from) / climb;
    const Vec3<Real> beside =
        add_scaled(node, transform_point(node, ray.origin, across), step, drift);
    child.ray.origin = add_scaled(node, beside, height, up);
    child.ray.direction = add_scaled(node, drift, climb, up);
    child.ray.base = ray.base + step;
}

/// The ray of a child of a steep object. `composed`, if it is wanted, is the parent's M^-1: it is
/// made short enough for the child's to be in range.
template <NodeLike Node, class Real = typename Node::Real>
void enter_steep(Node& node, const Cell<Real>& parent, std::uint32_t map, Cell<Real>& child,
                 Linear<Real>* composed) noexcept {
    node.tally(Operation::call, 1);
    node.tally(Operation::integer, 3);
    enter_along_axis(node, parent.ray, map + MapRecord<real_words<Real>>::words, child);
    shorten(node, child.ray.direction);
    if (composed != nullptr) shorten(node, *composed);
}

}  // namespace pxm::kernels
