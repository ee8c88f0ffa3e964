// Lights: Lambert's law (Eq. 17.1) on a surface. A directional light falls on the total normal; a
// point light on every cell of the path by itself, where the ray enters it (Eq. 17.3 in full: the
// shortcut of the total normal errs by the size of the cells).
// Node code: no allocation, no exceptions.
#pragma once

#include "dsp_kernels/shade.hpp"

namespace pxm::kernels {

/// What lights fall on: a surface at a place, and where hierarchical shading needs it, its cell.
template <class Real>
struct LitPlace {
    Surface<Real> surface;           // its normal, colours and shares
    Vec3<Real> point;                // of the world
    Real pixel;                      // p there
    const Sighting<Real>* sighting;  // null on a plane
};

/// The unit vector from a point to a light that stands at `place` (Eq. 17.2).
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Vec3<Real> direction_to_point_light(Node& node, const Vec3<Real>& point,
                                                  const Vec3<Real>& place) noexcept {
    return normalize(node, subtract(node, place, point));
}

/// Lambert's cosine, 0 on the side away from the light.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Real facing(Node& node, const Vec3<Real>& normal,
                          const Vec3<Real>& to_light) noexcept {
    node.tally(Operation::select, 1);
    const Real cosine = dot(node, normal, to_light);
    return cosine < Real(0) ? Real(0) : cosine;
}

/// Adds up what a point light gives the cells of a path.
template <NodeLike Node>
struct AddPointLight {
    using Real = typename Node::Real;  // of the node
    Node& node;                        // that does the work
    const Ray<Real>& ray;              // that sees the path
    const Vec3<Real>& place;           // of the light
    PathSum<Node>& light;              // the sum
    /// Adds what a cell gets that the ray enters at t.
    void operator()(const Cell<Real>& cell, const Vec3<Real>& normal, Real t) const noexcept {
        const Vec3<Real> to_light = direction_to_point_light(node, point_at(node, ray, t), place);
        const Real cosine = facing(node, normal, to_light);
        light.add(node, {cosine, Real(0), Real(0)}, cell_diameter(node, cell));
    }
};

/// How much a place faces a point light: the weighted mean over the path of its cell.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Real facing_point_light(Node& node, const LitPlace<Real>& lit,
                                      const Vec3<Real>& place, ShadingMode mode) noexcept {
    node.tally(Operation::call, 1);
    if (lit.sighting == nullptr) {
        return facing(node, lit.surface.normal, direction_to_point_light(node, lit.point, place));
    }
    const Search<Real>& search = lit.sighting->search;
    PathSum<Node> light(mode, outermost_diameter(node, search, lit.sighting->cell.object));
    walk_path(node, *lit.sighting, mode, AddPointLight<Node>{node, search.ray, place, light});
    return light.mean(node).x;
}

/// The light that a place sends back (Eq. 17.1). `share(light)` says how much of a light arrives.
template <NodeLike Node, class Share, class Real = typename Node::Real>
[[nodiscard]] Vec3<Real> illuminate(Node& node, const LitPlace<Real>& lit, ShadingMode mode,
                                    const Share& share) noexcept {
    using Header = HeaderRecord<real_words<Real>>;
    using Light = LightRecord<real_words<Real>>;
    node.tally(Operation::call, 1);
    Vec3<Real> light_sum = read_vector(node, Header::ambient);
    std::uint32_t light = node.shape_word(Header::lights);
    for (std::uint32_t left = node.shape_word(Header::light_count); left > 0; --left) {
        node.tally(Operation::loop_turn, 1);
        node.tally(Operation::compare_branch, 1);
        node.tally(Operation::integer, 1);
        const Vec3<Real> place = read_vector(node, light + Light::place);
        const auto kind = static_cast<LightKind>(node.shape_word(light + Light::kind));
        const Real cosine = kind == LightKind::directional
                                ? facing(node, lit.surface.normal, place)
                                : facing_point_light(node, lit, place, mode);
        if (Real(0) < cosine) {
            node.tally(Operation::multiply_add, 2);
            light_sum = add_scaled(node, light_sum, lit.surface.diffuse * cosine * share(light),
                                   read_vector(node, light + Light::color));
        }
        light += Light::words;
    }
    node.tally(Operation::multiply_add, 3);
    const Vec3<Real>& color = lit.surface.color;
    return {light_sum.x * color.x, light_sum.y * color.y, light_sum.z * color.z};
}

}  // namespace pxm::kernels
