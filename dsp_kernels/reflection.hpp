// Mirror rays (Sec. 15.3). Node code: no allocation, no exceptions.
#pragma once

#include "dsp_kernels/search.hpp"

namespace pxm::kernels {

/// The mirrored search from a point with that unit normal, where the pixel has size `pixel`. It
/// begins at a distance of p, so that the mirror does not show in itself. p grows as it did: the
/// mirrored viewpoint E_1 (Eq. 15.5, Erratum 15) lies as far behind the mirror as the ray has come,
/// so p(t_e) / |R_o - E_1| of Eq. 15.6 is the growth there was, and in an orthographic view none.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Search<Real> mirrored(Node& node, const Search<Real>& search, const Vec3<Real>& point,
                                    Real pixel, const Vec3<Real>& normal) noexcept {
    node.tally(Operation::multiply_add, 1);
    node.tally(Operation::integer, 4);
    Search<Real> reflected = search;
    const Real along = dot(node, search.ray.direction, normal);
    reflected.ray = {
        point, normalize(node, add_scaled(node, search.ray.direction, -(along + along), normal)),
        Real(0)};
    reflected.start = pixel;
    reflected.end = far_away<Real>;
    reflected.pixel = {pixel, search.pixel.growth};  // Eq. 15.6
    return reflected;
}

}  // namespace pxm::kernels
