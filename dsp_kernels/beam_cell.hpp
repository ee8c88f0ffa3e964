// Cells as a beam sees them: a pixel's worth of rays side by side. Each cell is carried forward
// into the beam's own frame instead of the rays back into the cell's, so that one look tells which
// of the pixel's places its volume may cover. A cell of a beam keeps in `linear` its composed
// linear part followed by the frame, and in `ray.origin` where its own origin lies.
// Node code: no allocation, no exceptions.
#pragma once

#include "dsp_kernels/descend.hpp"
#include "dsp_kernels/footprint.hpp"

namespace pxm::kernels {

inline constexpr std::uint32_t most_places = 32;  // of a beam: a bit of a word each

/// Across the pixel, down it, and along the ray: unit vectors at right angles.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Linear<Real> beam_frame(Node& node, const Vec3<Real>& along) noexcept {
    using Header = HeaderRecord<real_words<Real>>;
    const Vec3<Real> across = read_vector(node, Header::across);
    const Vec3<Real> down = read_vector(node, Header::down);
    const Vec3<Real> x =
        normalize(node, add_scaled(node, across, -dot(node, across, along), along));
    Vec3<Real> y = add_scaled(node, down, -dot(node, down, along), along);
    y = normalize(node, add_scaled(node, y, -dot(node, y, x), x));
    return {{x, y, along}};
}

/// The cell of the empty word of an object, seen from the beam's origin in its frame.
template <NodeLike Node, class Real = typename Node::Real>
void outermost_beam_cell(Node& node, const Vec3<Real>& origin, const Linear<Real>& frame,
                         std::uint32_t object, Cell<Real>& cell) noexcept {
    using Object = ObjectRecord<real_words<Real>>;
    const Linear<Real> linear = read_linear(node, object + Object::linear);
    const Vec3<Real> back = read_vector(node, object + Object::inverse + 9 * real_words<Real>);
    const Vec3<Real> place = negate(transform_direction(node, back, linear));
    cell.ray.origin = transform_normal(node, subtract(node, place, origin), frame);
    for (std::uint32_t i = 0; i < 3; ++i) {
        cell.linear.rows[i] = transform_normal(node, linear.rows[i], frame);
    }
    node.tally(Operation::integer, 5);
    cell.constant = node.shape_real(object + Object::constant);
    cell.object = object;
    cell.follow_set = node.shape_word(object + Object::start_set);
    cell.lost_axes = 0;
    cell.level = 0;
    cell.bits = static_cast<std::uint16_t>(node.shape_word(object + Object::symbol_bits));
}

/// The cell of a map inside `parent`, without its word. What the map's inverse takes to 0 is where
/// the child's origin lies: x = -b T for x W^-1 = x T^-1 + b.
template <NodeLike Node, class Real = typename Node::Real>
void beam_child(Node& node, const Cell<Real>& parent, std::uint32_t map,
                Cell<Real>& child) noexcept {
    using Map = MapRecord<real_words<Real>>;
    node.tally(Operation::multiply_add, 1);
    node.tally(Operation::integer, 5);
    child.linear = compose(node, read_linear(node, map + Map::linear), parent.linear);
    const Vec3<Real> back = read_vector(node, map + Map::inverse + 9 * real_words<Real>);
    child.ray.origin =
        subtract(node, parent.ray.origin, transform_direction(node, back, child.linear));
    child.constant = parent.constant * node.shape_real(map + Map::constant);
    child.object = parent.object;
    child.follow_set = node.shape_word(map + Map::follow_set);
    child.lost_axes = 0;
    child.level = static_cast<std::uint16_t>(parent.level + 1);
    child.bits = parent.bits;
}

/// The word of a child that is kept.
template <NodeLike Node, class Real = typename Node::Real>
void extend_word(Node& node, const Cell<Real>& parent, std::uint32_t map,
                 Cell<Real>& child) noexcept {
    using Map = MapRecord<real_words<Real>>;
    const std::uint32_t used = CellWord::used(parent.level, parent.bits);
    node.tally(Operation::integer, 4U + used);
    for (std::uint32_t i = 0; i < used; ++i) child.word.packed[i] = parent.word.packed[i];
    child.word.set(parent.level, parent.bits, node.shape_word(map + Map::symbol));
}

/// Where the centre of the cell's volume lies in the beam's frame.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Vec3<Real> center_in_beam(Node& node, const Cell<Real>& cell) noexcept {
    using FollowSet = FollowSetRecord<real_words<Real>>;
    const Vec3<Real> center = read_vector(node, cell.follow_set + FollowSet::center);
    return add_scaled(node, cell.ray.origin, Real(1),
                      transform_direction(node, center, cell.linear));
}

/// No point of the cell's volume is farther from its centre along an axis of the beam's frame.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Vec3<Real> reach_in_beam(Node& node, const Cell<Real>& cell) noexcept {
    using FollowSet = FollowSetRecord<real_words<Real>>;
    const Vec3<Real>* r = cell.linear.rows;
    node.tally(Operation::integer, 1);
    const auto kind = static_cast<Volume>(node.shape_word(cell.follow_set + FollowSet::volume));
    if (kind == Volume::box) {
        node.tally(Operation::select, 9);
        const Vec3<Real> h = subtract(node, read_vector(node, cell.follow_set + FollowSet::high),
                                      read_vector(node, cell.follow_set + FollowSet::center));
        const auto along = [&](Real a, Real b, Real c) {
            node.tally(Operation::dot_product, 1);
            return sum_of_products(h.x, absolute(a), h.y, absolute(b), h.z, absolute(c));
        };
        return {along(r[0].x, r[1].x, r[2].x), along(r[0].y, r[1].y, r[2].y),
                along(r[0].z, r[1].z, r[2].z)};
    }
    // The centre of a hull is in it, but need not be its middle.
    Real radius = node.shape_real(cell.follow_set + FollowSet::diameter);
    node.tally(Operation::multiply_add, 4);
    node.tally(Operation::square_root, 3);
    if (kind != Volume::hull) radius = radius * from_double<Real>(0.5);
    const auto along = [&](Real a, Real b, Real c) {
        const Vec3<Real> column{a, b, c};
        return radius * square_root(dot(node, column, column));
    };
    return {along(r[0].x, r[1].x, r[2].x), along(r[0].y, r[1].y, r[2].y),
            along(r[0].z, r[1].z, r[2].z)};
}

/// p around a depth: its size there, and how it grows.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] PixelSize<Real> pixel_around(Node& node, const Search<Real>& search,
                                           std::uint32_t object, Real depth) noexcept {
    using Object = ObjectRecord<real_words<Real>>;
    node.tally(Operation::compare_branch, 1);
    const Real pixel = pixel_at(node, search, object, depth);
    const bool grows = node.shape_real(object + Object::smallest_pixel) < pixel;
    return {pixel, grows ? search.pixel.growth : Real(0)};
}

/// The way back into a cell: the adjugate over the determinant (Eq. 12.3).
template <class Real>
struct CellInverse {
    Linear<Real> crosses;  // cross products of the rows: the columns of the adjugate
    Real over_volume;      // 1 / determinant, 0 of a flat cell
    bool flat;             // there is none
};
/// Of the cell's linear part, three cross products and a reciprocal.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] CellInverse<Real> inverse_of(Node& node, const Cell<Real>& cell) noexcept {
    const Vec3<Real>* r = cell.linear.rows;
    const Linear<Real> crosses{
        {cross(node, r[1], r[2]), cross(node, r[2], r[0]), cross(node, r[0], r[1])}};
    const Real volume = dot(node, r[0], crosses.rows[0]);
    node.tally(Operation::compare_branch, 2);
    const bool flat = !(volume < Real(0)) && !(Real(0) < volume);
    node.tally(Operation::reciprocal, 1);
    return {crosses, flat ? Real(0) : reciprocal(volume), flat};
}

/// The ray through a place of the pixel near a cell, in the beam's frame: where it is as deep as
/// the cell's centre, from there, and how it goes on. In perspective it is not parallel to the
/// beam: if it were taken to be, cells that touch at different depths would leave a gap.
template <class Real>
struct PassingRay {
    Vec3<Real> aside;  // from the cell's centre
    Vec3<Real> along;  // for a unit along the beam
};

/// Whether a ray meets the cell's volume.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] bool passes(Node& node, const Cell<Real>& cell, const CellInverse<Real>& inverse,
                          const PassingRay<Real>& passing) noexcept {
    using FollowSet = FollowSetRecord<real_words<Real>>;
    const Vec3<Real> center = read_vector(node, cell.follow_set + FollowSet::center);
    Ray<Real> ray;
    ray.origin = add_scaled(node, center, inverse.over_volume,
                            transform_normal(node, passing.aside, inverse.crosses));
    ray.direction =
        scale(node, inverse.over_volume, transform_normal(node, passing.along, inverse.crosses));
    ray.base = cell.key;
    return intersect_volume(node, rebase(node, ray, center), cell.follow_set).has_value();
}

}  // namespace pxm::kernels
