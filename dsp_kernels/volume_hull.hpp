// Bounding polytopes: intersections of a few half-spaces.
// Node code: no allocation, no exceptions.
#pragma once

#include <optional>

#include "dsp_kernels/scene_block.hpp"
#include "dsp_kernels/volume_slab.hpp"

namespace pxm::kernels {

/// Where the ray crosses the plane of a half-space, and whether it goes in or out there.
template <class Real>
struct PlaneCrossing {
    Real t;      // from the ray's origin
    Real slope;  // negative: into the half-space; zero: along the plane, t is the height below it
};

/// Of one of a hull's planes; `from_center` is the ray's origin from the volume's centre.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] PlaneCrossing<Real> cross_plane(Node& node, const Vec3<Real>& from_center,
                                              const Vec3<Real>& direction,
                                              std::uint32_t plane) noexcept {
    using HalfSpace = HalfSpaceRecord<real_words<Real>>;
    const Vec3<Real> normal = read_vector(node, plane + HalfSpace::normal);
    node.tally(Operation::multiply_add, 2);
    node.tally(Operation::compare_branch, 2);
    const Real depth = node.shape_real(plane + HalfSpace::offset) - dot(node, from_center, normal);
    const Real slope = dot(node, direction, normal);
    if (!(slope < Real(0)) && !(Real(0) < slope)) return {depth, Real(0)};
    node.tally(Operation::reciprocal, 1);
    return {depth * reciprocal(slope), slope};
}

/// A polytope. Precondition: the ray was re-based to its centre; the polytope is bounded.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] std::optional<Interval<Real>> intersect_hull(Node& node, const Ray<Real>& ray,
                                                           std::uint32_t follow_set) noexcept {
    using FollowSet = FollowSetRecord<real_words<Real>>;
    using Hull = HullRecord<real_words<Real>>;
    node.tally(Operation::call, 1);
    node.tally(Operation::integer, 2);
    const Vec3<Real> from_center =
        subtract(node, ray.origin, read_vector(node, follow_set + FollowSet::center));
    const std::uint32_t hull = node.shape_word(follow_set + FollowSet::shape);
    std::uint32_t plane = hull + Hull::half_spaces;
    Interval<Real> inside{-far_away<Real>, far_away<Real>};
    for (std::uint32_t left = node.shape_word(hull + Hull::count); left > 0; --left) {
        node.tally(Operation::loop_turn, 1);
        node.tally(Operation::compare_branch, 3);
        const auto [t, slope] = cross_plane(node, from_center, ray.direction, plane);
        plane += HalfSpaceRecord<real_words<Real>>::words;
        if (slope < Real(0)) {
            if (inside.entry < t) inside.entry = t;
        } else if (Real(0) < slope) {
            if (t < inside.exit) inside.exit = t;
        } else if (t < Real(0)) {
            return {};
        }
        if (inside.exit < inside.entry) return {};
    }
    node.tally(Operation::multiply_add, 2);
    return Interval<Real>{ray.base + inside.entry, ray.base + inside.exit};
}

/// The outward normal of the face through which the ray enters or leaves: of the planes that it
/// goes in through the last, of those that it goes out through the first.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Vec3<Real> hull_normal(Node& node, const Ray<Real>& ray, Side side,
                                     std::uint32_t follow_set) noexcept {
    using FollowSet = FollowSetRecord<real_words<Real>>;
    using Hull = HullRecord<real_words<Real>>;
    using HalfSpace = HalfSpaceRecord<real_words<Real>>;
    const Vec3<Real> from_center =
        subtract(node, ray.origin, read_vector(node, follow_set + FollowSet::center));
    const std::uint32_t hull = node.shape_word(follow_set + FollowSet::shape);
    std::uint32_t plane = hull + Hull::half_spaces;
    std::uint32_t found = plane;
    const bool entry = side == Side::entry;
    Real best = least_decisive<Real>(side);
    for (std::uint32_t left = node.shape_word(hull + Hull::count); left > 0; --left) {
        node.tally(Operation::loop_turn, 1);
        node.tally(Operation::compare_branch, 2);
        const auto [t, slope] = cross_plane(node, from_center, ray.direction, plane);
        if (entry ? slope < Real(0) && best < t : Real(0) < slope && t < best) {
            best = t;
            found = plane;
        }
        plane += HalfSpace::words;
    }
    return read_vector(node, found + HalfSpace::normal);
}

}  // namespace pxm::kernels
