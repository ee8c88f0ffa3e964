// Planes, the floors and walls of a scene: where a ray meets the nearest one, and what it looks
// like there. Node code: no allocation, no exceptions.
#pragma once

#include "dsp_kernels/floor_block.hpp"
#include "dsp_kernels/footprint.hpp"
#include "dsp_kernels/shade.hpp"
#include "dsp_kernels/texture.hpp"

namespace pxm::kernels {

/// Where a ray meets a plane.
template <class Real>
struct PlaneHit {
    std::uint32_t plane = 0;  // address of its record; 0: no plane
    Real t{};                 // the ray's parameter
};

/// The parameter at which a ray meets a plane; nothing if it runs along it.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] std::optional<Real> meet_plane(Node& node, const Ray<Real>& ray,
                                             std::uint32_t plane) noexcept {
    using Plane = PlaneRecord<real_words<Real>>;
    const Vec3<Real> normal = read_vector(node, plane + Plane::normal);
    const Real towards = dot(node, ray.direction, normal);
    node.tally(Operation::compare_branch, 2);
    if (!(towards < Real(0)) && !(Real(0) < towards)) return {};
    node.tally(Operation::divide, 1);
    node.tally(Operation::multiply_add, 2);
    const Real height = node.shape_real(plane + Plane::offset) - dot(node, ray.origin, normal);
    return ray.base + height / towards;
}

/// Finds the nearest plane that a ray meets between the parameters `from` and `to`, both left out.
/// Of planes that coincide it is the first. False, and `hit` as it was, if there is none.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] bool nearest_plane(Node& node, const Ray<Real>& ray, Real from, Real to,
                                 PlaneHit<Real>& hit) noexcept {
    using Header = HeaderRecord<real_words<Real>>;
    using Plane = PlaneRecord<real_words<Real>>;
    node.tally(Operation::call, 1);
    bool found = false;
    std::uint32_t plane = node.shape_word(Header::planes);
    for (std::uint32_t left = node.shape_word(Header::plane_count); left > 0; --left) {
        node.tally(Operation::loop_turn, 1);
        node.tally(Operation::compare_branch, 2);
        const std::optional<Real> t = meet_plane(node, ray, plane);
        if (t && from < *t && *t < to) {
            node.tally(Operation::integer, 2);
            hit = {plane, *t};
            to = *t;
            found = true;
        }
        plane += Plane::words;
    }
    return found;
}

/// The size of a pixel at a plane. It is never so small that rounding would put a shadow ray on the
/// plane's other side (design decision 4, for the ray's length).
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Real pixel_on_plane(Node& node, const PixelSize<Real>& pixel, Real t) noexcept {
    constexpr Real share = from_double<Real>(real_words<Real> == 1 ? 0x1p-20 : 0x1p-48);
    node.tally(Operation::multiply_add, 1);
    return pixel_size(node, pixel, t, share * t);
}

/// What a ray sees of a plane: a normal that faces the ray's origin, and the colour of the plane
/// times those of its textures within a pixel of size p. The ray's direction is a unit vector.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Surface<Real> plane_surface(Node& node, const Ray<Real>& ray, Real p,
                                          const PlaneHit<Real>& hit) noexcept {
    using Plane = PlaneRecord<real_words<Real>>;
    using Layer = LayerRecord<real_words<Real>>;
    node.tally(Operation::call, 1);
    Surface<Real> surface;
    surface.normal = read_vector(node, hit.plane + Plane::normal);
    surface.color = read_vector(node, hit.plane + Plane::color);
    surface.diffuse = node.shape_real(hit.plane + Plane::diffuse);
    surface.reflect = node.shape_real(hit.plane + Plane::reflect);
    node.tally(Operation::compare_branch, 1);
    if (Real(0) < dot(node, ray.direction, surface.normal)) {
        surface.normal = negate(surface.normal);
    }
    std::uint32_t left = node.shape_word(hit.plane + Plane::layer_count);
    if (left == 0) return surface;
    const Vec3<Real> point = point_at(node, ray, hit.t);
    const Footprint<Real> foot = footprint(node, ray.direction, surface.normal, p);
    std::uint32_t layer = node.shape_word(hit.plane + Plane::layers);
    for (; left > 0; --left) {
        node.tally(Operation::loop_turn, 1);
        node.tally(Operation::multiply_add, 3);
        const Vec3<Real> color = layer_color(node, layer, point, foot);
        surface.color = {surface.color.x * color.x, surface.color.y * color.y,
                         surface.color.z * color.z};
        layer += Layer::words;
    }
    return surface;
}

}  // namespace pxm::kernels
