// The size of a pixel (Ch. 15), a linear function of the distance along a ray.
// Node code: no allocation, no exceptions.
#pragma once

#include "dsp_kernels/vector.hpp"

namespace pxm::kernels {

/// p(t) = at_origin + growth t. Eye rays of a perspective view start at zero and grow by
/// 2 tan(theta/2) / N_h, the upper bound of Eq. 15.2 (Erratum 14); in an orthographic view p is
/// width / columns everywhere.
template <class Real>
struct PixelSize {
    Real at_origin;  // p(0), in scene units
    Real growth;     // a unit of the way
};

/// p_l(t) at distance t from a light: zero there, p(t_e) at the surface at distance t_l (Eq. 15.3).
/// From the surface on it is the same size at the same place (Eq. 15.4).
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] PixelSize<Real> light_pixel_size(Node& node, Real at_surface,
                                               Real distance) noexcept {
    node.tally(Operation::compare_branch, 1);
    if (!(Real(0) < distance)) return {at_surface, Real(0)};
    node.tally(Operation::divide, 1);
    return {Real(0), at_surface / distance};
}

/// p(t), never below `smallest`: numbers of a node do not resolve less at an object's scale.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Real pixel_size(Node& node, const PixelSize<Real>& pixel, Real t,
                              Real smallest) noexcept {
    node.tally(Operation::multiply_add, 1);
    node.tally(Operation::select, 1);
    const Real p = pixel.at_origin + pixel.growth * t;
    return p < smallest ? smallest : p;
}

}  // namespace pxm::kernels
