// Flat cells: inside a singular map, which the host lifted to the thickness of a pixel. Along the
// axes that such a map lost, what is inside it is squashed no further: the lifts of one word would
// multiply, leave nothing to hit, and overflow. The picture of a flat set does not depend on its
// thickness. Node code: no allocation, no exceptions.
#pragma once

#include "dsp_kernels/cell.hpp"
#include "dsp_kernels/scene_block.hpp"
#include "dsp_kernels/search.hpp"

namespace pxm::kernels {

inline constexpr std::uint32_t most_lost_axes = 2;  // of a map whose image is a line

/// Brings the ray nearer to a centre along a unit axis, by the factor `squash`: the cell becomes as
/// much thicker there.
template <NodeLike Node, class Real = typename Node::Real>
void undo_squash(Node& node, const Vec3<Real>& center, const Vec3<Real>& axis, Real squash,
                 Ray<Real>& ray) noexcept {
    node.tally(Operation::multiply_add, 3);
    const Real share = Real(1) - squash;
    const Real height = dot(node, subtract(node, ray.origin, center), axis);
    const Real speed = dot(node, ray.direction, axis);
    ray.origin = add_scaled(node, ray.origin, -(share * height), axis);
    ray.direction = add_scaled(node, ray.direction, -(share * speed), axis);
}

/// The thickness that a lifted map leaves a child along a unit axis that it lost, in scene units.
/// Needs the parent's composed linear part.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Real thickness_along(Node& node, const Vec3<Real>& axis, const Cell<Real>& parent,
                                   std::uint32_t map, const Cell<Real>& child) noexcept {
    using FollowSet = FollowSetRecord<real_words<Real>>;
    using Map = MapRecord<real_words<Real>>;
    const Vec3<Real> image = transform_direction(
        node, transform_direction(node, axis, read_linear(node, map + Map::linear)), parent.linear);
    node.tally(Operation::multiply_add, 1);
    return dot(node, image, normalize(node, image)) *
           node.shape_real(child.follow_set + FollowSet::diameter);
}

/// A map loses an axis: the child gets the thickness of a pixel along it, whatever is left of the
/// host's lift under the maps outside (known where Lipschitz constants are computed by polar
/// decomposition, as they are by default where maps are singular).
template <NodeLike Node, class Real = typename Node::Real>
void lose_axis(Node& node, const Search<Real>& search, const Vec3<Real>& center,
               const Vec3<Real>& axis, const Cell<Real>& parent, std::uint32_t map,
               Cell<Real>& child) noexcept {
    node.tally(Operation::integer, 4);
    child.lost[child.lost_axes++] = axis;
    if (!is_polar(node, child.object)) return;
    node.tally(Operation::select, 1);
    node.tally(Operation::multiply_add, 1);
    node.tally(Operation::compare_branch, 1);
    const Real t = parent.ray.base < Real(0) ? Real(0) : parent.ray.base;
    const Real p = search.detail * pixel_at(node, search, child.object, t);
    const Real thickness = thickness_along(node, axis, parent, map, child);
    if (!(thickness < p)) return;
    node.tally(Operation::divide, 1);
    undo_squash(node, center, axis, thickness / p, child.ray);
}

/// Carries the lost axes of the parent into the child, undoes what the map squashed along them, and
/// adds the axes that the map itself loses.
template <NodeLike Node, class Real = typename Node::Real>
void keep_thickness(Node& node, const Search<Real>& search, const Cell<Real>& parent,
                    std::uint32_t map, Cell<Real>& child) noexcept {
    using FollowSet = FollowSetRecord<real_words<Real>>;
    using Map = MapRecord<real_words<Real>>;
    node.tally(Operation::call, 1);
    node.tally(Operation::integer, 2);
    const std::uint32_t lost_here = node.shape_word(map + Map::lost_axes);
    if (parent.lost_axes == 0 && lost_here == 0) return;
    const Vec3<Real> center = read_vector(node, child.follow_set + FollowSet::center);
    const Linear<Real> inverse = read_linear(node, map + Map::inverse);
    for (std::uint32_t i = 0; i < parent.lost_axes; ++i) {
        node.tally(Operation::loop_turn, 1);
        const Vec3<Real> stretched = transform_direction(node, parent.lost[i], inverse);
        const Vec3<Real> axis = normalize(node, stretched);
        const Real stretch = dot(node, stretched, axis);  // over 1 where the map squashes
        node.tally(Operation::compare_branch, 1);
        if (Real(1) < stretch) {
            node.tally(Operation::reciprocal, 1);
            undo_squash(node, center, axis, reciprocal(stretch), child.ray);
        }
        node.tally(Operation::integer, 4);
        child.lost[child.lost_axes++] = axis;
    }
    constexpr Real nearly_parallel = from_double<Real>(0.5);
    for (std::uint32_t i = 0; i < lost_here && child.lost_axes < most_lost_axes; ++i) {
        node.tally(Operation::loop_turn, 1);
        const Vec3<Real> axis = read_vector(node, map + Map::lost + 3 * i * real_words<Real>);
        bool known = false;
        for (std::uint32_t k = 0; k < child.lost_axes; ++k) {
            node.tally(Operation::loop_turn, 1);
            node.tally(Operation::select, 1);
            node.tally(Operation::compare_branch, 1);
            known = known || nearly_parallel < absolute(dot(node, axis, child.lost[k]));
        }
        if (!known) lose_axis(node, search, center, axis, parent, map, child);
    }
}

}  // namespace pxm::kernels
