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
    Real at_origin;
    Real growth;
};

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
