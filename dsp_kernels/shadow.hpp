// Shadow rays (Sec. 15.2): what part of a light reaches a point. To a directional light they are
// cast from the surface, where p stays as it is there; from a point light they are cast to the
// surface, p growing from zero at the light to p(t_e) at the surface.
// Node code: no allocation, no exceptions.
#pragma once

#include "dsp_kernels/lights.hpp"
#include "dsp_kernels/pixel_size.hpp"

namespace pxm::kernels {

/// From a surface to a directional light. It begins at a distance of p from the surface, so that
/// the surface does not shadow itself. `pixel` is p(t_e).
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Search<Real> search_to_light(Node& node, const Search<Real>& eye,
                                           const Vec3<Real>& point, Real pixel,
                                           const Vec3<Real>& direction) noexcept {
    node.tally(Operation::integer, 4);
    Search<Real> search = eye;
    search.ray = {point, direction, Real(0)};
    search.start = pixel;
    search.end = far_away<Real>;
    search.pixel = {pixel, Real(0)};  // Eq. 15.4 for a light infinitely far away
    return search;
}

/// From a point light to a surface. What is nearer to the surface than p is the surface: that is
/// the "closeness criterion" of Sec. 15.2.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Search<Real> search_from_light(Node& node, const Search<Real>& eye,
                                             const Vec3<Real>& point, Real pixel,
                                             const Vec3<Real>& place) noexcept {
    node.tally(Operation::integer, 4);
    Search<Real> search = eye;
    const Vec3<Real> way = subtract(node, point, place);
    const Vec3<Real> direction = normalize(node, way);
    const Real distance = dot(node, way, direction);  // t_l
    search.ray = {place, direction, Real(0)};
    search.start = Real(0);
    search.end = distance - pixel;
    search.pixel = light_pixel_size(node, pixel, distance);
    return search;
}

}  // namespace pxm::kernels
