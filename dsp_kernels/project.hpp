// A ray and the cells of a system of homotheties, seen along the ray (Sec. 13.1, 13.2). Maps that
// scale uniformly and translate leave directions alone, so that all cells share one ray direction:
// projected along it a ray is a point, a ball a disc, and a map a map of the plane (Eq. 13.6).
// A cell then is where the point lies in its disc, and where its centre lies along the ray. Node
// code: no allocation, no exceptions.
#pragma once

#include "dsp_kernels/descend.hpp"

namespace pxm::kernels {

/// The ray in the coordinates of an object, and the plane across it.
template <class Real>
struct ProjectedRay {
    Vec3<Real> u;          // unit vectors of the plane
    Vec3<Real> v;          // across u
    Vec3<Real> along;      // the ray's direction, a unit vector too
    Real constant;         // Lipschitz constant of the object over the ray's parameter
    std::uint32_t object;  // address of its record
    std::uint16_t bits;    // of a symbol
};

/// A cell seen along the ray. Lengths are in the cell's own coordinates.
template <class Real>
struct ProjectedCell {
    Real x{};                      // where the ray lies in the disc, from its centre
    Real y{};                      // across x
    Real t{};                      // the ray's parameter at the centre
    Real scale{};                  // of the ray's parameter for a unit of the cell
    Real key{};                    // the ray's interval, Erratum 3
    Real exit{};                   // the interval's end
    std::uint32_t follow_set = 0;  // address
    std::uint32_t level = 0;       // length of its word
    std::uint32_t symbol = 0;      // of the last map of its word
};

/// The plane across a ray: the first two columns of Eq. 13.2, whose first rotation has to be
/// divided by h (Erratum 20). Where the ray is vertical that rotation is free.
template <NodeLike Node, class Real = typename Node::Real>
void set_plane(Node& node, ProjectedRay<Real>& ray) noexcept {
    const Vec3<Real>& d = ray.along;
    node.tally(Operation::multiply_add, 2);
    node.tally(Operation::square_root, 1);
    node.tally(Operation::compare_branch, 1);
    const Real h = square_root(d.x * d.x + d.z * d.z);
    if (!(Real(0) < h)) {
        ray.u = {Real(1), Real(0), Real(0)};
        ray.v = {Real(0), Real(0), Real(1)};
        return;
    }
    node.tally(Operation::reciprocal, 1);
    node.tally(Operation::multiply_add, 4);
    const Real inverse = reciprocal(h);
    const Real sine = d.x * inverse;
    const Real cosine = d.z * inverse;
    ray.u = {cosine, Real(0), -sine};
    ray.v = {-(sine * d.y), h, -(cosine * d.y)};
}

/// Sets the cell's interval (t_0 and t_1 of its ball, clipped to [from, to]); false if the point is
/// not in the disc (Sec. 13.3) or the interval is empty.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] bool include_point(Node& node, ProjectedCell<Real>& cell, Real from,
                                 Real to) noexcept {
    using FollowSet = FollowSetRecord<real_words<Real>>;
    const Real radius = node.shape_real(cell.follow_set + FollowSet::radius);
    node.tally(Operation::multiply_add, 3);
    node.tally(Operation::compare_branch, 1);
    const Real half_chord2 = radius * radius - (cell.x * cell.x + cell.y * cell.y);
    if (half_chord2 < Real(0)) return false;
    node.tally(Operation::square_root, 1);
    node.tally(Operation::multiply_add, 3);
    node.tally(Operation::select, 2);
    const Real half = square_root(half_chord2) * cell.scale;
    const Real entry = cell.t - half;
    const Real exit = cell.t + half;
    cell.key = from < entry ? entry : from;
    cell.exit = exit < to ? exit : to;
    node.tally(Operation::compare_branch, 1);
    return !(cell.exit < cell.key);
}

/// The ray seen from an object, and the object's outermost cell in `cell`, its interval not set.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] ProjectedRay<Real> project_ray(Node& node, const Search<Real>& search,
                                             std::uint32_t object,
                                             ProjectedCell<Real>& cell) noexcept {
    using Object = ObjectRecord<real_words<Real>>;
    using FollowSet = FollowSetRecord<real_words<Real>>;
    node.tally(Operation::call, 1);
    node.tally(Operation::integer, 4);
    cell.follow_set = node.shape_word(object + Object::start_set);
    cell.level = 0;
    cell.symbol = 0;
    const Vec3<Real> center = read_vector(node, cell.follow_set + FollowSet::center);
    const Ray<Real> local = rebase(
        node, transform_ray(node, search.ray, read_affine(node, object + Object::inverse)), center);
    ProjectedRay<Real> ray;
    ray.object = object;
    ray.bits = static_cast<std::uint16_t>(node.shape_word(object + Object::symbol_bits));
    ray.along = normalize(node, local.direction);
    set_plane(node, ray);
    node.tally(Operation::reciprocal, 1);
    node.tally(Operation::multiply_add, 1);
    const Real length = dot(node, local.direction, ray.along);  // of the direction, for t = 1
    ray.constant = node.shape_real(object + Object::constant) * length;
    const Vec3<Real> offset = subtract(node, local.origin, center);
    cell.x = dot(node, offset, ray.u);
    cell.y = dot(node, offset, ray.v);
    cell.t = local.base;
    cell.scale = reciprocal(length);
    return ray;
}

/// The cell of a map inside `parent`, whose ball has the given centre: its interval is not set. The
/// ray's point x becomes x W_i^-1, taken from centre to centre.
template <NodeLike Node, class Real = typename Node::Real>
void project_child(Node& node, const ProjectedRay<Real>& ray, const ProjectedCell<Real>& parent,
                   const Vec3<Real>& parent_center, std::uint32_t map,
                   ProjectedCell<Real>& child) noexcept {
    using Map = MapRecord<real_words<Real>>;
    using FollowSet = FollowSetRecord<real_words<Real>>;
    node.tally(Operation::integer, 3);
    child.follow_set = node.shape_word(map + Map::follow_set);
    child.symbol = node.shape_word(map + Map::symbol);
    child.level = parent.level + 1;
    const Real back = node.shape_real(map + Map::inverse);  // 1 / s_i
    const Vec3<Real> offset = read_vector(node, map + Map::inverse + 9 * real_words<Real>);
    const Real scale = node.shape_real(map + Map::linear);  // s_i
    const Vec3<Real> center = read_vector(node, child.follow_set + FollowSet::center);
    const Vec3<Real> step = subtract(node, add_scaled(node, offset, back, parent_center), center);
    node.tally(Operation::multiply_add, 4);
    child.x = parent.x * back + dot(node, step, ray.u);  // Eq. 13.6
    child.y = parent.y * back + dot(node, step, ray.v);
    child.scale = parent.scale * scale;
    child.t = parent.t - child.scale * dot(node, step, ray.along);
}

/// Step 2.3 of Alg. 12.4 for a projected cell.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Ending ending(Node& node, const Search<Real>& search, const ProjectedRay<Real>& ray,
                            const ProjectedCell<Real>& cell) noexcept {
    using Object = ObjectRecord<real_words<Real>>;
    using FollowSet = FollowSetRecord<real_words<Real>>;
    node.tally(Operation::integer, 4);
    if (cell.level == node.shape_word(ray.object + Object::levels)) return Ending::terminal;
    node.tally(Operation::multiply_add, 3);
    node.tally(Operation::compare_branch, 1);
    const Real p = pixel_at(node, search, ray.object, cell.key);
    const Real diameter =
        ray.constant * cell.scale * node.shape_real(cell.follow_set + FollowSet::diameter);
    if (!(search.detail * p < diameter)) return Ending::terminal;
    if (cell.level >= CellWord::longest(ray.bits)) return Ending::word_full;
    return Ending::goes_on;
}

}  // namespace pxm::kernels
