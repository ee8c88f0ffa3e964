// Hierarchical shading (Ch. 17): a fractal has no normal, its bounding volumes have. The cells on
// the path from the outermost cell to the terminal one (Erratum 13) are walked again along the
// word, and their normals and the colours of the maps are gathered on the way. Node code: no
// allocation, no exceptions.
#pragma once

#include "dsp_kernels/descend.hpp"

namespace pxm::kernels {

/// What a light falls on.
template <class Real>
struct Surface {
    Vec3<Real> normal;  // the total normal, a unit vector
    Vec3<Real> color;   // c_x of Eq. 17.1
    Real diffuse;       // k_d
};

/// The weighted sum of the normals along a path (Eq. 17.3).
template <NodeLike Node, class Real = typename Node::Real>
class TotalNormal {
  public:
    TotalNormal(ShadingMode mode, Real outermost_diameter) noexcept
        : mode_(mode), outermost_diameter_(outermost_diameter) {}

    /// Adds the unit normal of a cell of that diameter.
    void add(Node& node, const Vec3<Real>& normal, Real diameter) noexcept {
        const Real weight = weight_of(node, diameter);
        node.tally(Operation::multiply_add, 1);
        weighted_ = add_scaled(node, weighted_, weight, normal);
        unweighted_ = add_scaled(node, unweighted_, Real(1), normal);
        total_weight_ = total_weight_ + weight;
    }
    /// Whether any cell gave a normal.
    [[nodiscard]] bool empty(Node& node) const noexcept {
        node.tally(Operation::compare_branch, 1);
        return !(Real(0) < dot(node, unweighted_, unweighted_));
    }
    /// The total normal, of unit length. When all weights vanish, the constant weighting (Erratum
    /// 18).
    [[nodiscard]] Vec3<Real> unit(Node& node) const noexcept {
        node.tally(Operation::compare_branch, 1);
        return normalize(node, Real(0) < total_weight_ ? weighted_ : unweighted_);
    }

  private:
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
    Real total_weight_{};
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

/// The surface at a terminal cell. A cell around the eye gives no normal; if no cell gives one, it
/// is the normal where the ray leaves the terminal cell.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Surface<Real> surface_at(Node& node, const Search<Real>& search,
                                       const Cell<Real>& hit, ShadingMode mode) noexcept {
    using Object = ObjectRecord<real_words<Real>>;
    using Map = MapRecord<real_words<Real>>;
    node.tally(Operation::call, 1);
    Surface<Real> surface;
    surface.color = read_vector(node, hit.object + Object::color);
    surface.diffuse = node.shape_real(hit.object + Object::diffuse);
    Linear<Real> inverse = read_linear(node, hit.object + Object::inverse);
    const bool polar = is_polar(node, hit.object);

    Cell<Real> cell;
    outermost_cell(node, search, hit.object, cell);
    TotalNormal<Node> total(mode, cell_diameter(node, cell));
    while (true) {
        node.tally(Operation::loop_turn, 1);
        approach(node, cell);
        const bool last = cell.level == hit.level;
        const auto inside = intersect_volume(node, cell.ray, cell.follow_set);
        node.tally(Operation::compare_branch, 1);
        node.tally(Operation::integer, 2);
        const bool entered = inside && Real(0) < inside->entry;
        if (entered && (last || mode != ShadingMode::facet)) {
            total.add(node, cell_normal(node, cell, inside->entry, Side::entry, inverse),
                      cell_diameter(node, cell));
        }
        if (last) {
            if (inside && total.empty(node)) {
                total.add(node, cell_normal(node, cell, inside->exit, Side::exit, inverse),
                          cell_diameter(node, cell));
            }
            surface.normal = total.unit(node);
            return surface;
        }
        node.tally(Operation::integer, 3);
        const std::uint32_t map =
            map_from(node, cell.follow_set, hit.word.get(cell.level, hit.bits));
        Cell<Real> child;
        child_cell(node, search, cell, map, child);
        if (polar) complete_child(node, cell, map, child);
        inverse =
            compose(node, inverse, read_linear(node, map + Map::inverse));  // M^-1 W_i1^-1 ...
        surface.color = blend(node, surface.color, map + Map::color);
        move_cell(node, cell, child);
    }
}

/// The unit vector from a point to a light that stands at `place`.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Vec3<Real> direction_to_point_light(Node& node, const Vec3<Real>& point,
                                                  const Vec3<Real>& place) noexcept {
    return normalize(node, subtract(node, place, point));
}

/// The unit vector from a point to a light, whatever its kind (Eq. 17.2).
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Vec3<Real> direction_to_light(Node& node, const Vec3<Real>& point,
                                            std::uint32_t light) noexcept {
    using Light = LightRecord<real_words<Real>>;
    const Vec3<Real> place = read_vector(node, light + Light::place);
    node.tally(Operation::integer, 1);
    if (static_cast<LightKind>(node.shape_word(light + Light::kind)) == LightKind::directional) {
        return place;
    }
    return direction_to_point_light(node, point, place);
}

/// Lambert's law (Eq. 17.1) with the total normal, at a point of the world.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Vec3<Real> illuminate(Node& node, const Surface<Real>& surface,
                                    const Vec3<Real>& point) noexcept {
    using Header = HeaderRecord<real_words<Real>>;
    using Light = LightRecord<real_words<Real>>;
    node.tally(Operation::call, 1);
    Vec3<Real> light_sum = read_vector(node, Header::ambient);
    std::uint32_t light = node.shape_word(Header::lights);
    for (std::uint32_t left = node.shape_word(Header::light_count); left > 0; --left) {
        node.tally(Operation::loop_turn, 1);
        node.tally(Operation::compare_branch, 1);
        const Real facing = dot(node, surface.normal, direction_to_light(node, point, light));
        if (Real(0) < facing) {
            node.tally(Operation::multiply_add, 1);
            light_sum = add_scaled(node, light_sum, surface.diffuse * facing,
                                   read_vector(node, light + Light::color));
        }
        light += Light::words;
    }
    node.tally(Operation::multiply_add, 3);
    return {light_sum.x * surface.color.x, light_sum.y * surface.color.y,
            light_sum.z * surface.color.z};
}

}  // namespace pxm::kernels
