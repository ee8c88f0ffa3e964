// A flat attractor as a texture, by point inclusion (Alg. 7.2, with Erratum 4: the new map goes on
// the inside, as in Alg. 12.4). The algorithm asks whether the point is in B_0, in which w_j(B),
// and so on; here it asks how far the spot is from the nearest of them that is much smaller than
// the spot. The picture is that of the attractor thickened by half a pixel, with soft edges.
// Node code: no allocation, no exceptions.
#pragma once

#include "dsp_kernels/floor_block.hpp"
#include "dsp_kernels/footprint.hpp"

namespace pxm::kernels {

inline constexpr int inclusion_levels = 40;          // deepest cell; it counts as a point
inline constexpr int inclusion_cells = 4096;         // most cells looked at for one spot
inline constexpr double inclusion_fineness = 0.125;  // radius of a cell that is a point, in spots

/// A cell (B, i) of Alg. 7.2 in the coordinates of the spot, where its ellipse has diameter 1 and
/// the centre is 0: the map w_i1 ... w_ik, and which of the maps inside come next.
template <class Real>
struct PointCell {
    Vec2<Real> rows[2];      // linear part
    Vec2<Real> offset;       // of the map
    Real stretch = Real(0);  // largest singular value of the linear part
    std::uint32_t next = 0;  // address in a list of maps
    std::uint32_t left = 0;  // maps not yet looked at
};

/// d T, for the rows of T.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Vec2<Real> times(Node& node, const Vec2<Real>& d, const Vec2<Real>* rows) noexcept {
    node.tally(Operation::multiply_add, 4);
    return {d.u * rows[0].u + d.v * rows[1].u, d.u * rows[0].v + d.v * rows[1].v};
}

/// a + b.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Vec2<Real> sum(Node& node, const Vec2<Real>& a, const Vec2<Real>& b) noexcept {
    node.tally(Operation::multiply_add, 2);
    return {a.u + b.u, a.v + b.v};
}

/// Of the vector (u, v).
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Real length(Node& node, Real u, Real v) noexcept {
    node.tally(Operation::multiply_add, 2);
    node.tally(Operation::square_root, 1);
    return square_root(u * u + v * v);
}

/// Two numbers from a word address on.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Vec2<Real> read_vec2(Node& node, std::uint32_t address) noexcept {
    const Real u = node.shape_real(address);
    return {u, node.shape_real(address + real_words<Real>)};
}

/// The largest singular value of a cell's linear part (Eq. 16.9, closed in two dimensions).
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Real largest_stretch(Node& node, const PointCell<Real>& cell) noexcept {
    node.tally(Operation::multiply_add, 6);
    const Vec2<Real>* r = cell.rows;
    return from_double<Real>(0.5) * (length(node, r[0].u + r[1].v, r[0].v - r[1].u) +
                                     length(node, r[0].u - r[1].v, r[0].v + r[1].u));
}

/// The search for the nearest point of an attractor, no farther than the best so far.
template <NodeLike Node>
class Inclusion {
  public:
    using Real = typename Node::Real;              // of the node
    using Set = PointSetRecord<real_words<Real>>;  // a follow set's record
    using Map = PointMapRecord<real_words<Real>>;  // a map's record

    explicit Inclusion(Node& node) noexcept : node_(node) {}  // nothing found yet

    /// The distance found so far, in diameters of the spot: 1 if it is no less.
    [[nodiscard]] Real distance() const noexcept { return best_; }

    /// Looks for points of the attractor of a set whose place is `outermost`.
    void search(const PointCell<Real>& outermost, std::uint32_t set) noexcept {
        stack_[0] = outermost;
        if (!is_open(stack_[0], set, 0)) return;
        int level = 0;
        while (level >= 0) {
            node_.tally(Operation::loop_turn, 1);
            node_.tally(Operation::integer, 4);
            PointCell<Real>& cell = stack_[level];
            if (cell.left == 0) {
                --level;
                continue;
            }
            --cell.left;
            const std::uint32_t map = node_.shape_word(cell.next++);
            go_inside(cell, map, stack_[level + 1]);
            const std::uint32_t inside = node_.shape_word(map + Map::point_set);
            if (is_open(stack_[level + 1], inside, level + 1)) ++level;
        }
    }

  private:
    /// Step 3.2.1: the image of the cell's content under a map, inside the cell.
    void go_inside(const PointCell<Real>& cell, std::uint32_t map,
                   PointCell<Real>& child) noexcept {
        const Vec2<Real> u = read_vec2(node_, map + Map::linear);
        const Vec2<Real> v = read_vec2(node_, map + Map::linear + 2 * real_words<Real>);
        child.rows[0] = times(node_, u, cell.rows);
        child.rows[1] = times(node_, v, cell.rows);
        child.offset =
            sum(node_, times(node_, read_vec2(node_, map + Map::offset), cell.rows), cell.offset);
        node_.tally(Operation::compare_branch, 4);
        node_.tally(Operation::multiply_add, 1);
        const bool homothety = u.v == Real(0) && v.u == Real(0) && u.u == v.v && Real(0) < u.u;
        child.stretch = homothety ? u.u * cell.stretch : largest_stretch(node_, child);
    }

    /// Step 3.2.2: whether a point of the cell may be nearer than the best one. A cell that is as
    /// good as a point gives its distance instead.
    [[nodiscard]] bool is_open(PointCell<Real>& cell, std::uint32_t set, int level) noexcept {
        node_.tally(Operation::call, 1);
        node_.tally(Operation::multiply_add, 5);
        node_.tally(Operation::compare_branch, 3);
        node_.tally(Operation::integer, 4);
        ++cells_;
        const Vec2<Real> center =
            sum(node_, times(node_, read_vec2(node_, set + Set::center), cell.rows), cell.offset);
        const Real radius = node_.shape_real(set + Set::radius) * cell.stretch;
        const Real away2 = center.u * center.u + center.v * center.v;
        const Real reach = best_ + radius;
        if (!(away2 < reach * reach)) return false;
        if (!(from_double<Real>(inclusion_fineness) < radius) || level == inclusion_levels ||
            cells_ >= inclusion_cells) {
            node_.tally(Operation::square_root, 1);
            const Real away = square_root(away2);
            if (away < best_) best_ = away;
            return false;
        }
        cell.next = set + Set::maps;
        cell.left = node_.shape_word(set + Set::map_count);
        return true;
    }

    Node& node_;
    Real best_ = Real(1);
    int cells_ = 0;
    PointCell<Real> stack_[inclusion_levels + 1];
};

/// From the coordinates of a texture to those of a spot.
template <class Real>
struct ToSpot {
    Vec2<Real> rows[2];  // of its linear part
};

/// The outermost cell of the attractor except its place, and the map into the coordinates of the
/// spot. False if the spot has no area.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] bool outermost_point_cell(Node& node, std::uint32_t texture, const Spot<Real>& spot,
                                        PointCell<Real>& cell, ToSpot<Real>& to_spot) noexcept {
    using Texture = TextureRecord<real_words<Real>>;
    node.tally(Operation::multiply_add, 10);
    node.tally(Operation::compare_branch, 1);
    node.tally(Operation::reciprocal, 1);
    const Real area = spot.minor.u * spot.major.v - spot.minor.v * spot.major.u;
    if (!(Real(0) < area) && !(area < Real(0))) return false;
    const Real per_area = reciprocal(area);
    // The inverse of the map that takes the unit square to the spot's axes.
    to_spot.rows[0] = {spot.major.v * per_area, -spot.minor.v * per_area};
    to_spot.rows[1] = {-spot.major.u * per_area, spot.minor.u * per_area};
    const Vec2<Real> step = read_vec2(node, texture + Texture::step);
    cell.rows[0] = {step.u * to_spot.rows[0].u, step.u * to_spot.rows[0].v};
    cell.rows[1] = {step.v * to_spot.rows[1].u, step.v * to_spot.rows[1].v};
    cell.stretch = largest_stretch(node, cell);
    return true;
}

/// How much of a spot the attractor covers, from 0 to 1. The spot's repeat and those around it.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Real inclusion_coverage(Node& node, std::uint32_t texture,
                                      const Spot<Real>& spot) noexcept {
    using Texture = TextureRecord<real_words<Real>>;
    node.tally(Operation::call, 1);
    node.tally(Operation::multiply_add, 2);
    PointCell<Real> cell;
    ToSpot<Real> to_spot;
    if (!outermost_point_cell(node, texture, spot, cell, to_spot)) return Real(0);
    const std::uint32_t start = node.shape_word(texture + Texture::start_set);
    const Vec2<Real> corner = read_vec2(node, texture + Texture::corner);
    const Real u = corner.u - place_of(node, spot.at.u).fraction;
    const Real v = corner.v - place_of(node, spot.at.v).fraction;
    Inclusion<Node> inclusion(node);
    for (const int right : {0, 1, -1}) {
        for (const int up : {0, 1, -1}) {
            node.tally(Operation::loop_turn, 1);
            node.tally(Operation::to_float, 2);
            node.tally(Operation::multiply_add, 2);
            cell.offset = times(node, {u + from_double<Real>(right), v + from_double<Real>(up)},
                                to_spot.rows);
            inclusion.search(cell, start);
        }
    }
    return Real(1) - inclusion.distance();
}

/// The colour of a flat attractor within a spot: `color` on it, `color2` off it.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Vec3<Real> inclusion_color(Node& node, std::uint32_t texture,
                                         const Spot<Real>& spot) noexcept {
    using Texture = TextureRecord<real_words<Real>>;
    const Real coverage = inclusion_coverage(node, texture, spot);
    const Vec3<Real> on = read_vector(node, texture + Texture::color);
    const Vec3<Real> off = read_vector(node, texture + Texture::color2);
    return add_scaled(node, off, coverage, subtract(node, on, off));
}

}  // namespace pxm::kernels
