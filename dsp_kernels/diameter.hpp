// The diameter of a cell: the Lipschitz constant of its composed map times the diameter of its
// volume (Ch. 16). Three methods: the product of the maps' constants (Eq. 16.1, an upper bound),
// the cube root of the determinant (Eq. 16.3, a lower bound; Erratum 6), and the largest singular
// value by polar decomposition (Sec. 16.2), which is exact. Node code: no allocation, no
// exceptions.
#pragma once

#include <concepts>

#include "dsp_kernels/cell.hpp"
#include "dsp_kernels/scene_block.hpp"

namespace pxm::kernels {

inline constexpr int jacobi_sweeps = 8;  // cyclic Jacobi on a 3x3 matrix settles in four or five

/// A symmetric 3x3 matrix: diagonal xx, yy, zz and off-diagonal xy, yz, zx.
template <class Real>
struct Symmetric {
    Real xx;  // on the diagonal
    Real yy;  // on the diagonal
    Real zz;  // on the diagonal
    Real xy;  // beside it
    Real yz;  // beside it
    Real zx;  // beside it
};

/// An off-diagonal entry that is this much smaller than the difference of its two diagonal entries
/// turns nothing else: theta is then so large that its square would leave the range of Real, and
/// the rotation changes no entry by as much as a unit of its last place.
template <class Real>
inline constexpr Real turns_nothing = from_double<Real>(std::same_as<Real, double> ? 0x1p-500
                                                                                   : 0x1p-60);

/// One Jacobi rotation that makes `apq` vanish; `arp`, `arq` are the other two off-diagonal
/// entries.
template <NodeLike Node, class Real = typename Node::Real>
void jacobi_rotate(Node& node, Real& app, Real& aqq, Real& apq, Real& arp, Real& arq) noexcept {
    node.tally(Operation::select, 1);
    node.tally(Operation::compare_branch, 1);
    if (!(Real(0) < absolute(apq))) return;
    node.tally(Operation::select, 1);
    node.tally(Operation::multiply_add, 2);
    node.tally(Operation::compare_branch, 1);
    const Real difference = aqq - app;
    if (!(turns_nothing<Real> * absolute(difference) < absolute(apq))) {
        apq = Real(0);
        return;
    }
    node.tally(Operation::compare_branch, 1);
    node.tally(Operation::divide, 2);
    node.tally(Operation::square_root, 1);
    node.tally(Operation::reciprocal_square_root, 1);
    node.tally(Operation::multiply_add, 11);
    const Real theta = difference / (apq + apq);
    const Real root = square_root(theta * theta + Real(1));
    const Real t = Real(1) / (theta < Real(0) ? theta - root : theta + root);
    const Real c = reciprocal_square_root(t * t + Real(1));
    const Real s = t * c;
    app = app - t * apq;
    aqq = aqq + t * apq;
    apq = Real(0);
    const Real old = arp;
    arp = c * old - s * arq;
    arq = s * old + c * arq;
}

/// The largest singular value of T: the root of the largest eigenvalue of T T^t (Eq. 16.9), by
/// Jacobi rotations on the matrix scaled to entries of at most 1.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Real largest_singular_value(Node& node, const Linear<Real>& linear) noexcept {
    node.tally(Operation::call, 1);
    node.tally(Operation::select, 18);  // nine magnitudes, the larger nine times
    Real largest = Real(0);
    for (const Vec3<Real>& row : linear.rows) {
        for (const Real entry : {row.x, row.y, row.z}) {
            if (largest < absolute(entry)) largest = absolute(entry);
        }
    }
    if (!(Real(0) < largest)) return Real(0);
    node.tally(Operation::compare_branch, 1);
    node.tally(Operation::reciprocal, 1);
    const Real inverse = reciprocal(largest);
    const Vec3<Real> x = scale(node, inverse, linear.rows[0]);
    const Vec3<Real> y = scale(node, inverse, linear.rows[1]);
    const Vec3<Real> z = scale(node, inverse, linear.rows[2]);
    Symmetric<Real> s{dot(node, x, x), dot(node, y, y), dot(node, z, z),
                      dot(node, x, y), dot(node, y, z), dot(node, z, x)};
    constexpr Real negligible = from_double<Real>(1e-12);
    for (int sweep = 0; sweep < jacobi_sweeps; ++sweep) {
        node.tally(Operation::loop_turn, 1);
        node.tally(Operation::dot_product, 1);
        node.tally(Operation::compare_branch, 1);
        const Real off = sum_of_products(s.xy, s.xy, s.yz, s.yz, s.zx, s.zx);
        if (!(negligible * negligible < off)) break;
        jacobi_rotate(node, s.xx, s.yy, s.xy, s.zx, s.yz);
        jacobi_rotate(node, s.yy, s.zz, s.yz, s.xy, s.zx);
        jacobi_rotate(node, s.zz, s.xx, s.zx, s.yz, s.xy);
    }
    node.tally(Operation::select, 2);
    node.tally(Operation::square_root, 1);
    node.tally(Operation::multiply_add, 1);
    Real lambda = s.xx < s.yy ? s.yy : s.xx;
    if (lambda < s.zz) lambda = s.zz;
    return largest * square_root(lambda);
}

/// Lip of the composed map times the diameter of the cell's volume, in scene units.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Real cell_diameter(Node& node, const Cell<Real>& cell) noexcept {
    using Object = ObjectRecord<real_words<Real>>;
    using FollowSet = FollowSetRecord<real_words<Real>>;
    const auto method = static_cast<Lipschitz>(node.shape_word(cell.object + Object::lipschitz));
    node.tally(Operation::integer, 1);
    node.tally(Operation::multiply_add, 1);
    const Real constant =
        method == Lipschitz::polar ? largest_singular_value(node, cell.linear) : cell.constant;
    return constant * node.shape_real(cell.follow_set + FollowSet::diameter);
}

}  // namespace pxm::kernels
