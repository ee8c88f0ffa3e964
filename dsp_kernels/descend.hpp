// Going down one level of the hierarchy: from an object to its outermost cell, from a cell to the
// cell of a map that may come next (steps 1.1 and 2.4.1 to 2.4.4 of Alg. 12.4). Node code: no
// allocation, no exceptions.
#pragma once

#include "dsp_kernels/cell.hpp"
#include "dsp_kernels/diameter.hpp"
#include "dsp_kernels/flatness.hpp"
#include "dsp_kernels/scene_block.hpp"
#include "dsp_kernels/search.hpp"
#include "dsp_kernels/steepness.hpp"
#include "dsp_kernels/volume.hpp"

namespace pxm::kernels {

/// Relative error of a ray's parameter that rounding may cause: a few units in the last place, half
/// of the smallest pixel (design decision 4).
template <class Real>
inline constexpr Real rounding_slack = from_double<Real>(real_words<Real> == 1 ? 0x1p-21 : 0x1p-49);

/// Brings the cell's ray near its volume, ready to be intersected with it.
template <NodeLike Node, class Real = typename Node::Real>
void approach(Node& node, Cell<Real>& cell) noexcept {
    using FollowSet = FollowSetRecord<real_words<Real>>;
    cell.ray = rebase(node, cell.ray, read_vector(node, cell.follow_set + FollowSet::center));
}

/// The ray as a volume that fits tightly meets it under local covers: about half again as large,
/// but by no more than some pixels. A sphere stands out of what it bounds, so that a ray that
/// passes the object nearby meets it; boxes may not stand out at all. Shrinking the ray about the
/// centre grows the volume, whatever its kind.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Ray<Real> shrunk_for_covers(Node& node, const Search<Real>& search,
                                          const Cell<Real>& cell) noexcept {
    using FollowSet = FollowSetRecord<real_words<Real>>;
    constexpr Real bulge = from_double<Real>(0.5);
    node.tally(Operation::call, 1);
    node.tally(Operation::multiply_add, 4);
    node.tally(Operation::select, 2);
    node.tally(Operation::divide, 1);
    const Real t = cell.ray.base < search.start ? search.start : cell.ray.base;
    const Real band = search.fade * pixel_at(node, search, cell.object, t);
    const Real size = cell.constant * node.shape_real(cell.follow_set + FollowSet::diameter);
    const Real share = size < band + band ? Real(1) : (band + band) / size;
    node.tally(Operation::reciprocal, 1);
    const Real shrink = reciprocal(Real(1) + bulge * share);
    const Vec3<Real> center = read_vector(node, cell.follow_set + FollowSet::center);
    const Vec3<Real> from_center = subtract(node, cell.ray.origin, center);
    return {add_scaled(node, center, shrink, from_center), scale(node, shrink, cell.ray.direction),
            cell.ray.base};
}

/// Whether an object stops at this cell whatever its size.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] bool at_last_level(Node& node, const Cell<Real>& cell) noexcept {
    node.tally(Operation::integer, 2);
    return cell.level == node.shape_word(cell.object + ObjectRecord<real_words<Real>>::levels);
}

/// The part of the whole line that lies in the cell's volume, for a ray that approached it.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] std::optional<Interval<Real>> intersect_cell(Node& node, const Search<Real>& search,
                                                           const Cell<Real>& cell) noexcept {
    using FollowSet = FollowSetRecord<real_words<Real>>;
    const auto kind = static_cast<Volume>(node.shape_word(cell.follow_set + FollowSet::volume));
    node.tally(Operation::integer, 1);
    if (kind == Volume::sphere || !has_covers(node, search) || at_last_level(node, cell)) {
        return intersect_volume(node, cell.ray, cell.follow_set);
    }
    return intersect_volume(node, shrunk_for_covers(node, search, cell), cell.follow_set);
}

/// Step 2.4.4: intersects the cell's own ray with its volume (Erratum 2) and sets its interval,
/// clipped to [from, to] (Erratum 3). False if the ray does not meet the cell.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] bool meet(Node& node, const Search<Real>& search, Cell<Real>& cell, Real from,
                        Real to) noexcept {
    approach(node, cell);
    const auto inside = intersect_cell(node, search, cell);
    if (!inside) return false;
    node.tally(Operation::select, 2);
    cell.key = from < inside->entry ? inside->entry : from;
    cell.exit = inside->exit < to ? inside->exit : to;
    node.tally(Operation::compare_branch, 1);
    if (!(cell.exit < cell.key)) return true;
    // A flat cell's interval is a point: rounding alone may separate it from its parent's.
    node.tally(Operation::multiply_add, 2);
    node.tally(Operation::compare_branch, 1);
    if (cell.key - cell.exit > rounding_slack<Real> * cell.key) return false;
    cell.exit = cell.key;
    return true;
}

/// Step 1.1: the cell of the empty word of an object. Its interval is not set yet.
template <NodeLike Node, class Real = typename Node::Real>
void outermost_cell(Node& node, const Search<Real>& search, std::uint32_t object,
                    Cell<Real>& cell) noexcept {
    using Object = ObjectRecord<real_words<Real>>;
    cell.ray = transform_ray(node, search.ray, read_affine(node, object + Object::inverse));
    cell.constant = node.shape_real(object + Object::constant);
    if (is_polar(node, object)) cell.linear = read_linear(node, object + Object::linear);
    cell.object = object;
    cell.follow_set = node.shape_word(object + Object::start_set);
    cell.lost_axes = 0;
    cell.level = 0;
    cell.bits = static_cast<std::uint16_t>(node.shape_word(object + Object::symbol_bits));
}

/// Steps 2.4.1 to 2.4.3: the cell of a map inside `parent`. Its interval is not set yet, nor its
/// composed linear part (complete_child). o M^-1 W_i^-1 is computed as (o M^-1) W_i^-1.
/// Precondition: the parent's word has room for one more symbol. `composed`, if it is wanted, is
/// the parent's M^-1; where maps are steep it is made short enough for the child's.
template <NodeLike Node, class Real = typename Node::Real>
void child_cell(Node& node, const Search<Real>& search, const Cell<Real>& parent, std::uint32_t map,
                Cell<Real>& child, Linear<Real>* composed = nullptr) noexcept {
    using Map = MapRecord<real_words<Real>>;
    using Object = ObjectRecord<real_words<Real>>;
    child.ray = transform_ray(node, parent.ray, read_affine(node, map + Map::inverse));
    node.tally(Operation::multiply_add, 1);
    node.tally(Operation::integer, 9U + CellWord::used(parent.level, parent.bits));
    child.constant = parent.constant * node.shape_real(map + Map::constant);
    child.object = parent.object;
    child.follow_set = node.shape_word(map + Map::follow_set);
    child.level = static_cast<std::uint16_t>(parent.level + 1);
    child.bits = parent.bits;
    const std::uint32_t used = CellWord::used(parent.level, parent.bits);
    for (std::uint32_t i = 0; i < used; ++i) child.word.packed[i] = parent.word.packed[i];
    child.word.set(parent.level, parent.bits, node.shape_word(map + Map::symbol));
    child.lost_axes = 0;
    const std::uint32_t squash = node.shape_word(child.object + Object::squash);
    if (squash == 0) return;
    node.tally(Operation::integer, 2);
    if ((squash & squash_steep) != 0) enter_steep(node, parent, map, child, composed);
    if ((squash & squash_flat) != 0) keep_thickness(node, search, parent, map, child);
}

/// The composed linear part of a child that the ray meets: x T_i T_parent.
template <NodeLike Node, class Real = typename Node::Real>
void complete_child(Node& node, const Cell<Real>& parent, std::uint32_t map,
                    Cell<Real>& child) noexcept {
    using Map = MapRecord<real_words<Real>>;
    child.linear = compose(node, read_linear(node, map + Map::linear), parent.linear);
}

/// The address of the first map in a follow set whose symbol is at least `symbol`; 0 if none is.
template <NodeLike Node>
[[nodiscard]] std::uint32_t map_from(Node& node, std::uint32_t follow_set,
                                     std::uint32_t symbol) noexcept {
    constexpr std::uint32_t R = real_words<typename Node::Real>;
    const std::uint32_t list = follow_set + FollowSetRecord<R>::maps;
    const std::uint32_t count = node.shape_word(follow_set + FollowSetRecord<R>::map_count);
    node.tally(Operation::call, 1);
    std::uint32_t low = 0;
    std::uint32_t high = count;
    while (low < high) {
        node.tally(Operation::loop_turn, 1);
        node.tally(Operation::integer, 4);
        const std::uint32_t middle = (low + high) / 2;
        const std::uint32_t map = node.shape_word(list + middle);
        if (node.shape_word(map + MapRecord<R>::symbol) < symbol) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low < count ? node.shape_word(list + low) : 0;
}

/// Whether the search ends at a cell that the ray meets.
enum class Ending { goes_on, terminal, word_full };

/// Step 2.3: a cell is terminal at its object's last level, or no larger than `detail` pixels.
/// A word that is full ends the search too, but the ray counts as capped.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Ending ending(Node& node, const Search<Real>& search, const Cell<Real>& cell,
                            Real diameter, Real pixel) noexcept {
    node.tally(Operation::integer, 2);
    if (at_last_level(node, cell)) return Ending::terminal;
    node.tally(Operation::multiply_add, 1);
    node.tally(Operation::compare_branch, 1);
    if (!(search.detail * pixel < diameter)) return Ending::terminal;
    if (cell.level >= CellWord::longest(cell.bits)) return Ending::word_full;
    return Ending::goes_on;
}

/// The same with the diameter and the pixel of the cell.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Ending ending(Node& node, const Search<Real>& search,
                            const Cell<Real>& cell) noexcept {
    return ending(node, search, cell, cell_diameter(node, cell),
                  pixel_at(node, search, cell.object, cell.key));
}

}  // namespace pxm::kernels
