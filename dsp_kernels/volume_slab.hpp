// A slab: what lies between two parallel planes. Boxes are intersections of three of them, cones
// and cylinders end at one. Node code: no allocation, no exceptions.
#pragma once

#include "dsp_kernels/ray.hpp"

namespace pxm::kernels {

/// Which end of a ray's interval in a volume.
enum class Side { entry, exit };

/// Clips `interval` (t measured from the ray's origin) to low <= o + t d <= high along one axis.
/// False if nothing is left.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] bool clip_to_slab(Node& node, Real o, Real d, Real low, Real high,
                                Interval<Real>& interval) noexcept {
    node.tally(Operation::compare_branch, 2);
    if (!(d < Real(0)) && !(Real(0) < d)) {
        node.tally(Operation::compare_branch, 2);
        return !(o < low) && !(high < o);
    }
    node.tally(Operation::compare_branch, 1);
    node.tally(Operation::reciprocal, 1);
    node.tally(Operation::multiply_add, 4);
    node.tally(Operation::select, 4);
    const Real inverse = reciprocal(d);
    Real first = (low - o) * inverse;
    Real second = (high - o) * inverse;
    if (second < first) {
        const Real swapped = first;
        first = second;
        second = swapped;
    }
    if (interval.entry < first) interval.entry = first;
    if (second < interval.exit) interval.exit = second;
    return !(interval.exit < interval.entry);
}

/// Whether the ray enters the slab later than `best` (leaves it earlier): then `best` becomes that
/// t, and the face points along the axis (1) or against it (-1). Else 0.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] int decisive_face(Node& node, Side side, Real o, Real d, Real low, Real high,
                                Real& best) noexcept {
    node.tally(Operation::compare_branch, 3);
    if (!(d < Real(0)) && !(Real(0) < d)) return 0;
    const bool entry = side == Side::entry;
    const bool low_face = (Real(0) < d) == entry;
    node.tally(Operation::divide, 1);
    node.tally(Operation::multiply_add, 1);
    const Real t = ((low_face ? low : high) - o) / d;
    if (entry ? !(best < t) : !(t < best)) return 0;
    best = t;
    return low_face ? -1 : 1;
}

/// What decisive_face() starts with.
template <class Real>
[[nodiscard]] Real least_decisive(Side side) noexcept {
    return side == Side::entry ? -far_away<Real> : far_away<Real>;
}

}  // namespace pxm::kernels
