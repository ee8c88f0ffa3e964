// Bounding volumes: where a ray enters and leaves them, and their normals there (Sec. 12.2).
// Volumes stay where they are; it is the ray that was transformed (Sec. 12.5).
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

/// Clips `interval` (t measured from the ray's origin) to low <= o + t d <= high along one axis.
/// False if nothing is left.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] bool clip_to_slab(Node& node, Real o, Real d, Real low, Real high,
                                Interval<Real>& interval) noexcept {
    node.tally(Operation::compare_branch, 2);
    if (!(d < Real(0)) && !(Real(0) < d)) {
        node.tally(Operation::compare_branch, 2);
        return !(o < low) && !(high < o);
    }
    node.tally(Operation::compare_branch, 1);
    node.tally(Operation::reciprocal, 1);
    node.tally(Operation::multiply_add, 4);
    node.tally(Operation::select, 4);
    const Real inverse = reciprocal(d);
    Real first = (low - o) * inverse;
    Real second = (high - o) * inverse;
    if (second < first) {
        const Real swapped = first;
        first = second;
        second = swapped;
    }
    if (interval.entry < first) interval.entry = first;
    if (second < interval.exit) interval.exit = second;
    return !(interval.exit < interval.entry);
}

/// A box with its edges along the axes.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] std::optional<Interval<Real>> intersect_box(Node& node, const Ray<Real>& ray,
                                                          std::uint32_t follow_set) noexcept {
    using FollowSet = FollowSetRecord<real_words<Real>>;
    node.tally(Operation::call, 1);
    const Vec3<Real> low = read_vector(node, follow_set + FollowSet::low);
    const Vec3<Real> high = read_vector(node, follow_set + FollowSet::high);
    constexpr Real far = from_double<Real>(1e30);  // farther than any scene in scene units
    Interval<Real> inside{-far, far};
    if (!clip_to_slab(node, ray.origin.x, ray.direction.x, low.x, high.x, inside)) return {};
    if (!clip_to_slab(node, ray.origin.y, ray.direction.y, low.y, high.y, inside)) return {};
    if (!clip_to_slab(node, ray.origin.z, ray.direction.z, low.z, high.z, inside)) return {};
    node.tally(Operation::multiply_add, 2);
    return Interval<Real>{ray.base + inside.entry, ray.base + inside.exit};
}

/// The part of the whole line that lies in the volume of a follow set; t as along the world's ray.
/// Precondition: the ray was re-based to the volume's centre.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] std::optional<Interval<Real>> intersect_volume(Node& node, const Ray<Real>& ray,
                                                             std::uint32_t follow_set) noexcept {
    using FollowSet = FollowSetRecord<real_words<Real>>;
    const auto kind = static_cast<Volume>(node.shape_word(follow_set + FollowSet::volume));
    node.tally(Operation::integer, 1);
    if (kind == Volume::sphere) return intersect_sphere(node, ray, follow_set);
    return intersect_box(node, ray, follow_set);
}

/// How many times a sphere must grow about its centre to reach a point.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Real sphere_gauge(Node& node, const Vec3<Real>& from_center,
                                std::uint32_t follow_set) noexcept {
    using FollowSet = FollowSetRecord<real_words<Real>>;
    node.tally(Operation::square_root, 1);
    node.tally(Operation::divide, 1);
    return square_root(dot(node, from_center, from_center)) /
           node.shape_real(follow_set + FollowSet::radius);
}

template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Real box_gauge(Node& node, const Vec3<Real>& from_center,
                             std::uint32_t follow_set) noexcept {
    using FollowSet = FollowSetRecord<real_words<Real>>;
    const Vec3<Real> low = read_vector(node, follow_set + FollowSet::low);
    const Vec3<Real> size = subtract(node, read_vector(node, follow_set + FollowSet::high), low);
    node.tally(Operation::divide, 3);
    node.tally(Operation::select, 5);
    node.tally(Operation::multiply_add, 1);
    const Real x = absolute(from_center.x) / size.x;
    const Real y = absolute(from_center.y) / size.y;
    const Real z = absolute(from_center.z) / size.z;
    const Real largest = x < y ? (y < z ? z : y) : (x < z ? z : x);
    return largest + largest;
}

/// How many times the volume of a follow set must grow about its centre to reach a point: at most 1
/// inside.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Real volume_gauge(Node& node, const Vec3<Real>& point,
                                std::uint32_t follow_set) noexcept {
    using FollowSet = FollowSetRecord<real_words<Real>>;
    const auto kind = static_cast<Volume>(node.shape_word(follow_set + FollowSet::volume));
    const Vec3<Real> from_center =
        subtract(node, point, read_vector(node, follow_set + FollowSet::center));
    node.tally(Operation::integer, 1);
    if (kind == Volume::sphere) return sphere_gauge(node, from_center, follow_set);
    return box_gauge(node, from_center, follow_set);
}

/// Which end of a ray's interval in a volume.
enum class Side { entry, exit };

/// The outward normal of a sphere where the ray has parameter t, of any length.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Vec3<Real> sphere_normal(Node& node, const Ray<Real>& ray, Real t,
                                       std::uint32_t follow_set) noexcept {
    using FollowSet = FollowSetRecord<real_words<Real>>;
    node.tally(Operation::multiply_add, 1);
    const Vec3<Real> point = add_scaled(node, ray.origin, t - ray.base, ray.direction);
    return subtract(node, point, read_vector(node, follow_set + FollowSet::center));
}

/// The outward normal of the box face through which the ray enters or leaves: of the slabs' entries
/// the last, of their exits the first.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Vec3<Real> box_normal(Node& node, const Ray<Real>& ray, Side side,
                                    std::uint32_t follow_set) noexcept {
    using FollowSet = FollowSetRecord<real_words<Real>>;
    const Vec3<Real> low = read_vector(node, follow_set + FollowSet::low);
    const Vec3<Real> high = read_vector(node, follow_set + FollowSet::high);
    const Real zero = Real(0);
    const bool entry = side == Side::entry;
    Vec3<Real> normal{};
    Real best = from_double<Real>(entry ? -1e30 : 1e30);
    const auto face = [&](Real o, Real d, Real low_face, Real high_face, Real outward_x,
                          Real outward_y, Real outward_z) {
        node.tally(Operation::compare_branch, 3);
        if (!(d < zero) && !(zero < d)) return;
        const bool forward = zero < d;
        node.tally(Operation::divide, 1);
        node.tally(Operation::multiply_add, 1);
        const Real t = ((forward == entry ? low_face : high_face) - o) / d;
        if (entry ? !(best < t) : !(t < best)) return;
        best = t;
        normal = {outward_x, outward_y, outward_z};
        if (forward == entry) normal = negate(normal);
    };
    face(ray.origin.x, ray.direction.x, low.x, high.x, Real(1), zero, zero);
    face(ray.origin.y, ray.direction.y, low.y, high.y, zero, Real(1), zero);
    face(ray.origin.z, ray.direction.z, low.z, high.z, zero, zero, Real(1));
    return normal;
}

/// The outward normal of a follow set's volume at one end of its interval on the ray (t is that
/// end), of any length, in the volume's coordinates.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Vec3<Real> volume_normal(Node& node, const Ray<Real>& ray, Real t, Side side,
                                       std::uint32_t follow_set) noexcept {
    using FollowSet = FollowSetRecord<real_words<Real>>;
    const auto kind = static_cast<Volume>(node.shape_word(follow_set + FollowSet::volume));
    node.tally(Operation::integer, 1);
    if (kind == Volume::sphere) return sphere_normal(node, ray, t, follow_set);
    return box_normal(node, ray, side, follow_set);
}

}  // namespace pxm::kernels
