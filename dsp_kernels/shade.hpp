// Hierarchical shading (Ch. 17): a fractal has no normal, its bounding volumes have. The cells on
// the path from the outermost cell to the one that shows (Erratum 13) are walked again along the
// word, and their normals and the colours of the maps are gathered on the way.
// Node code: no allocation, no exceptions.
#pragma once

#include "dsp_kernels/descend.hpp"

namespace pxm::kernels {

/// What a light falls on.
template <class Real>
struct Surface {
    Vec3<Real> normal;  // the total normal, a unit vector
    Vec3<Real> color;   // c_x of Eq. 17.1
    Real diffuse;       // k_d
    Real reflect;       // share of a mirror's image
};

/// A cell that a ray came upon.
template <class Real>
struct Sighting {
    const Search<Real>& search;  // that came upon it
    const Cell<Real>& cell;      // the cell
    std::uint32_t map;  // 0, or the map inside the cell whose colour it has (dsp_kernels/covers)
};

/// The weighted sum of a vector of each cell along a path (Eq. 17.3): of the normals, or of what
/// lights give the cells.
template <NodeLike Node, class Real = typename Node::Real>
class PathSum {
  public:
    /// Of no cell yet.
    PathSum(ShadingMode mode, Real outermost_diameter) noexcept
        : mode_(mode), outermost_diameter_(outermost_diameter) {}

    /// Adds the vector of a cell of that diameter.
    void add(Node& node, const Vec3<Real>& vector, Real diameter) noexcept {
        const Real weight = weight_of(node, diameter);
        node.tally(Operation::multiply_add, 2);
        weighted_ = add_scaled(node, weighted_, weight, vector);
        unweighted_ = add_scaled(node, unweighted_, Real(1), vector);
        weight_ = weight_ + weight;
        count_ = count_ + Real(1);
    }
    /// The sum; when all weights vanish, that of the constant weighting (Erratum 18).
    [[nodiscard]] const Vec3<Real>& sum(Node& node) const noexcept {
        return weighs(node) ? weighted_ : unweighted_;
    }
    /// The sum divided by that of the weights. Precondition: something was added.
    [[nodiscard]] Vec3<Real> mean(Node& node) const noexcept {
        node.tally(Operation::reciprocal, 1);
        return weighs(node) ? scale(node, reciprocal(weight_), weighted_)
                            : scale(node, reciprocal(count_), unweighted_);
    }

  private:
    [[nodiscard]] bool weighs(Node& node) const noexcept {
        node.tally(Operation::compare_branch, 1);
        return Real(0) < weight_;
    }
    [[nodiscard]] Real weight_of(Node& node, Real diameter) const noexcept {
        node.tally(Operation::multiply_add, 1);
        node.tally(Operation::integer, 2);
        if (mode_ == ShadingMode::low_pass) return diameter;                         // Eq. 17.5
        if (mode_ == ShadingMode::high_pass) return outermost_diameter_ - diameter;  // Eq. 17.6
        return Real(1);                                                              // Eq. 17.4
    }

    ShadingMode mode_;
    Real outermost_diameter_;
    Vec3<Real> weighted_{};
    Vec3<Real> unweighted_{};
    Real weight_{};
    Real count_{};
};

/// c = (1 - a) c + a (r,g,b) with the four numbers at `address`.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Vec3<Real> blend(Node& node, const Vec3<Real>& color,
                               std::uint32_t address) noexcept {
    const Vec3<Real> paint = read_vector(node, address);
    const Real a = node.shape_real(address + 3 * real_words<Real>);
    node.tally(Operation::multiply_add, 1);
    return add_scaled(node, scale(node, Real(1) - a, color), a, paint);
}

/// The world's unit normal of a cell's volume where the ray enters it (or leaves it). `inverse` is
/// the linear part of the cell's composed inverse map: normals go through its transpose.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Vec3<Real> cell_normal(Node& node, const Cell<Real>& cell, Real t, Side side,
                                     const Linear<Real>& inverse) noexcept {
    return normalize(
        node, transform_normal(
                  node, normalize(node, volume_normal(node, cell.ray, t, side, cell.follow_set)),
                  inverse));
}

/// The cells around an object that only shade what is inside: `visit` as below for those that the
/// ray enters. Whether there are any.
template <NodeLike Node, class Visit, class Real = typename Node::Real>
bool walk_enclosing(Node& node, const Search<Real>& search, std::uint32_t object, Cell<Real>& cell,
                    const Visit& visit) noexcept {
    using Object = ObjectRecord<real_words<Real>>;
    bool visited = false;
    node.tally(Operation::integer, 1);
    while ((object = node.shape_word(object + Object::enclosing)) != 0) {
        node.tally(Operation::loop_turn, 1);
        outermost_cell(node, search, object, cell);
        approach(node, cell);
        const auto inside = intersect_volume(node, cell.ray, cell.follow_set);
        node.tally(Operation::compare_branch, 1);
        if (!inside || !(search.start < inside->entry)) continue;
        const Linear<Real> inverse = read_linear(node, object + Object::inverse);
        visit(cell, cell_normal(node, cell, inside->entry, Side::entry, inverse), inside->entry);
        visited = true;
    }
    return visited;
}

/// Walks from the outermost cell to the one that was seen. `visit(cell, normal, t)` is
/// called for each cell on the way that gives a normal, the world's unit normal where the ray
/// enters it, and where that is. `facet` wants the last cell's only. A cell around the ray's start
/// gives none; if no cell gives one, it is the normal where the ray leaves the last cell, or points
/// along the ray where under local covers it passes all of them. Returns the surface's colour.
template <NodeLike Node, class Visit, class Real = typename Node::Real>
Vec3<Real> walk_path(Node& node, const Sighting<Real>& seen, ShadingMode mode,
                     const Visit& visit) noexcept {
    using Object = ObjectRecord<real_words<Real>>;
    using Map = MapRecord<real_words<Real>>;
    node.tally(Operation::call, 1);
    const Cell<Real>& hit = seen.cell;
    Vec3<Real> color = read_vector(node, hit.object + Object::color);
    Linear<Real> inverse = read_linear(node, hit.object + Object::inverse);
    const bool polar = is_polar(node, hit.object);
    Cell<Real> cell;
    bool visited = walk_enclosing(node, seen.search, hit.object, cell, visit);
    outermost_cell(node, seen.search, hit.object, cell);
    while (true) {
        node.tally(Operation::loop_turn, 1);
        approach(node, cell);
        const auto inside = intersect_volume(node, cell.ray, cell.follow_set);
        node.tally(Operation::compare_branch, 1);
        node.tally(Operation::integer, 2);
        const bool last = cell.level == hit.level;
        const bool entered = inside && seen.search.start < inside->entry;
        if (entered && (last || mode != ShadingMode::facet)) {
            visit(cell, cell_normal(node, cell, inside->entry, Side::entry, inverse),
                  inside->entry);
            visited = true;
        } else if (last && inside && !visited) {
            visit(cell, cell_normal(node, cell, inside->exit, Side::exit, inverse), inside->exit);
        } else if (last && !visited) {
            visit(cell, negate(seen.search.ray.direction), hit.key);
        }
        if (last) return color;
        node.tally(Operation::integer, 3);
        const std::uint32_t map =
            map_from(node, cell.follow_set, hit.word.get(cell.level, hit.bits));
        Cell<Real> child;
        child_cell(node, seen.search, cell, map, child, &inverse);
        if (polar) complete_child(node, cell, map, child);
        inverse =
            compose(node, inverse, read_linear(node, map + Map::inverse));  // M^-1 W_i1^-1 ...
        color = blend(node, color, map + Map::color);
        move_cell(node, cell, child);
    }
}

/// The diameter of the outermost cell of an object, for Eq. 17.6.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Real outermost_diameter(Node& node, const Search<Real>& search,
                                      std::uint32_t object) noexcept {
    using Object = ObjectRecord<real_words<Real>>;
    node.tally(Operation::integer, 1);
    while (const std::uint32_t around = node.shape_word(object + Object::enclosing)) {
        node.tally(Operation::loop_turn, 1);
        object = around;
    }
    Cell<Real> cell;
    outermost_cell(node, search, object, cell);
    return cell_diameter(node, cell);
}

/// Adds up the normals of a path.
template <NodeLike Node>
struct AddNormal {
    using Real = typename Node::Real;  // of the node
    Node& node;                        // that does the work
    PathSum<Node>& normals;            // the sum
    /// Adds the normal of a cell.
    void operator()(const Cell<Real>& cell, const Vec3<Real>& normal, Real) const noexcept {
        normals.add(node, normal, cell_diameter(node, cell));
    }
};

/// The surface of a cell, with the total normal: the shortcut of Sec. 17.3.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Surface<Real> surface_at(Node& node, const Sighting<Real>& seen,
                                       ShadingMode mode) noexcept {
    using Object = ObjectRecord<real_words<Real>>;
    using Map = MapRecord<real_words<Real>>;
    node.tally(Operation::call, 1);
    Surface<Real> surface;
    surface.diffuse = node.shape_real(seen.cell.object + Object::diffuse);
    surface.reflect = node.shape_real(seen.cell.object + Object::reflect);
    PathSum<Node> normals(mode, outermost_diameter(node, seen.search, seen.cell.object));
    surface.color = walk_path(node, seen, mode, AddNormal<Node>{node, normals});
    node.tally(Operation::integer, 1);
    if (seen.map != 0) surface.color = blend(node, surface.color, seen.map + Map::color);
    surface.normal = normalize(node, normals.sum(node));
    return surface;
}

}  // namespace pxm::kernels
