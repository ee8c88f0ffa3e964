// Three-vectors of a node's numbers. What a function costs is tallied where it is computed.
// Node code: no allocation, no exceptions.
#pragma once

#include "pxm/node_like.hpp"
#include "pxm/real.hpp"

namespace pxm::kernels {

/// A vector, or a point.
template <class Real>
struct Vec3 {
    Real x{};  // to the right
    Real y{};  // up
    Real z{};  // away from the viewer
};

/// a . b.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Real dot(Node& node, const Vec3<Real>& a, const Vec3<Real>& b) noexcept {
    node.tally(Operation::dot_product, 1);
    return sum_of_products(a.x, b.x, a.y, b.y, a.z, b.z);
}

/// a - b.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Vec3<Real> subtract(Node& node, const Vec3<Real>& a, const Vec3<Real>& b) noexcept {
    node.tally(Operation::multiply_add, 3);
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

/// a + s b.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Vec3<Real> add_scaled(Node& node, const Vec3<Real>& a, Real s,
                                    const Vec3<Real>& b) noexcept {
    node.tally(Operation::multiply_add, 3);
    return {a.x + s * b.x, a.y + s * b.y, a.z + s * b.z};
}

/// s a.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Vec3<Real> scale(Node& node, Real s, const Vec3<Real>& a) noexcept {
    node.tally(Operation::multiply_add, 3);
    return {s * a.x, s * a.y, s * a.z};
}

/// -a.
template <class Real>
[[nodiscard]] Vec3<Real> negate(const Vec3<Real>& a) noexcept {
    return {-a.x, -a.y, -a.z};
}

/// The unit vector along a; the null vector stays null. Large and small vectors are brought to a
/// size whose square neither overflows nor vanishes.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Vec3<Real> normalize(Node& node, const Vec3<Real>& a) noexcept {
    node.tally(Operation::call, 1);
    node.tally(Operation::select, 5);  // three magnitudes, the larger twice
    node.tally(Operation::compare_branch, 1);
    Real largest = absolute(a.x);
    if (largest < absolute(a.y)) largest = absolute(a.y);
    if (largest < absolute(a.z)) largest = absolute(a.z);
    if (!(Real(0) < largest)) return {};
    node.tally(Operation::reciprocal, 1);
    const Vec3<Real> sized = scale(node, reciprocal(largest), a);
    node.tally(Operation::reciprocal_square_root, 1);
    return scale(node, reciprocal_square_root(dot(node, sized, sized)), sized);
}

/// A vector stored as three numbers from `address` on.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Vec3<Real> read_vector(Node& node, std::uint32_t address) noexcept {
    constexpr std::uint32_t step = real_words<Real>;
    const Real x = node.shape_real(address);
    const Real y = node.shape_real(address + step);
    const Real z = node.shape_real(address + 2 * step);
    return {x, y, z};
}

}  // namespace pxm::kernels
