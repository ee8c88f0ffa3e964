// Affine maps on a node, in the thesis' convention: row vectors, x' = x T + a (Sec. 6.2).
// Node code: no allocation, no exceptions.
#pragma once

#include "dsp_kernels/vector.hpp"

namespace pxm::kernels {

/// The 3x3 linear part T, by rows.
template <class Real>
struct Linear {
    Vec3<Real> rows[3];  // in order
};

/// x' = x T + a.
template <class Real>
struct AffineMap {
    Linear<Real> linear;  // T
    Vec3<Real> offset;    // a
};

/// p T + a.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Vec3<Real> transform_point(Node& node, const Vec3<Real>& p,
                                         const AffineMap<Real>& map) noexcept {
    node.tally(Operation::transform_point, 1);
    const Vec3<Real>* r = map.linear.rows;
    return {sum_of_products(map.offset.x, p.x, r[0].x, p.y, r[1].x, p.z, r[2].x),
            sum_of_products(map.offset.y, p.x, r[0].y, p.y, r[1].y, p.z, r[2].y),
            sum_of_products(map.offset.z, p.x, r[0].z, p.y, r[1].z, p.z, r[2].z)};
}

/// d T.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Vec3<Real> transform_direction(Node& node, const Vec3<Real>& d,
                                             const Linear<Real>& linear) noexcept {
    node.tally(Operation::transform_direction, 1);
    const Vec3<Real>* r = linear.rows;
    return {sum_of_products(d.x, r[0].x, d.y, r[1].x, d.z, r[2].x),
            sum_of_products(d.x, r[0].y, d.y, r[1].y, d.z, r[2].y),
            sum_of_products(d.x, r[0].z, d.y, r[1].z, d.z, r[2].z)};
}

/// First a, then b: the product a b of the thesis.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Linear<Real> compose(Node& node, const Linear<Real>& a,
                                   const Linear<Real>& b) noexcept {
    return {{transform_direction(node, a.rows[0], b), transform_direction(node, a.rows[1], b),
             transform_direction(node, a.rows[2], b)}};
}

/// n T^t: takes a normal through a map when `linear` is the inverse map's linear part.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Vec3<Real> transform_normal(Node& node, const Vec3<Real>& n,
                                          const Linear<Real>& linear) noexcept {
    return {dot(node, n, linear.rows[0]), dot(node, n, linear.rows[1]),
            dot(node, n, linear.rows[2])};
}

/// Nine numbers by rows, from a word address on.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Linear<Real> read_linear(Node& node, std::uint32_t address) noexcept {
    constexpr std::uint32_t row = 3 * real_words<Real>;
    Linear<Real> linear;
    for (std::uint32_t i = 0; i < 3; ++i) linear.rows[i] = read_vector(node, address + i * row);
    return linear;
}

/// Twelve numbers from `address` on: rows 1 to 3, then row 4, the translation.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] AffineMap<Real> read_affine(Node& node, std::uint32_t address) noexcept {
    const Linear<Real> linear = read_linear(node, address);
    return {linear, read_vector(node, address + 9 * real_words<Real>)};
}

}  // namespace pxm::kernels
