// Eye rays (Sec. 13.1, Ch. 15): one through the centre of each pixel, or several through places
// that the host chose for all pixels alike.
// Node code: no allocation, no exceptions.
#pragma once

#include "dsp_kernels/ray.hpp"
#include "dsp_kernels/scene_block.hpp"

namespace pxm::kernels {

/// Through the eye and a point of the picture's plane, given from the eye.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Ray<Real> perspective_ray(Node& node, const Vec3<Real>& eye,
                                        const Vec3<Real>& on_plane) noexcept {
    return {eye, normalize(node, on_plane), Real(0)};
}

/// Through a point of the picture's plane, along the view.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Ray<Real> orthographic_ray(Node& node, const Vec3<Real>& eye,
                                         const Vec3<Real>& on_plane) noexcept {
    using Header = HeaderRecord<real_words<Real>>;
    return {add_scaled(node, eye, Real(1), on_plane), read_vector(node, Header::forward), Real(0)};
}

/// The eye's ray through a place in pixel (x, y): sample number `sample` of the broadcast table.
/// Its direction is a unit vector.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Ray<Real> eye_ray(Node& node, std::uint32_t x, std::uint32_t y,
                                std::uint32_t sample) noexcept {
    using Header = HeaderRecord<real_words<Real>>;
    node.tally(Operation::call, 1);
    node.tally(Operation::multiply_add, 2);
    node.tally(Operation::to_float, 2);
    node.tally(Operation::integer, 3);
    const std::uint32_t place = node.shape_word(Header::samples) + sample * 2 * real_words<Real>;
    const Real column = from_double<Real>(static_cast<double>(x)) + node.shape_real(place);
    const Real row =
        from_double<Real>(static_cast<double>(y)) + node.shape_real(place + real_words<Real>);
    const Vec3<Real> eye = read_vector(node, Header::eye);
    Vec3<Real> on_plane = read_vector(node, Header::corner);
    on_plane = add_scaled(node, on_plane, column, read_vector(node, Header::across));
    on_plane = add_scaled(node, on_plane, row, read_vector(node, Header::down));
    const auto projection = static_cast<Projection>(node.shape_word(Header::projection));
    if (projection == Projection::orthographic) return orthographic_ray(node, eye, on_plane);
    return perspective_ray(node, eye, on_plane);
}

}  // namespace pxm::kernels
