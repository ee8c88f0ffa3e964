// What the tracer does with local covers: it keeps some to shade them later, or lets them dim a
// light. Node code: no allocation, no exceptions.
#pragma once

#include "dsp_kernels/covers.hpp"
#include "dsp_kernels/pending_rays.hpp"

namespace pxm::kernels {

/// Covers found along a ray and not yet shaded: shadow rays need the heap, so that a search for
/// covers stops when the list is full, and goes on behind the last one later.
template <class Real>
struct CoverList {
    static constexpr std::uint32_t capacity = 8;
    struct Entry {
        Cell<Real> cell;
        Shown<Real> shown;
    };
    Entry entries[capacity];
    std::uint32_t size = 0;
};

/// Fills the list with what shows, until nothing shows behind.
template <NodeLike Node>
struct CollectCovers {
    using Real = typename Node::Real;
    Node& node;
    CoverList<Real>& list;
    Real& left;  // of the ray's share
    Real least;  // below it nothing is left
    bool operator()(const Cell<Real>& cell, const Shown<Real>& shown) const noexcept {
        node.tally(Operation::multiply_add, 2);
        node.tally(Operation::compare_branch, 1);
        node.tally(Operation::integer, 3);
        auto& entry = list.entries[list.size++];
        move_cell(node, entry.cell, cell);
        entry.shown = shown;
        left = left - left * shown.opacity;
        return !(left < least) && list.size < CoverList<Real>::capacity;
    }
};

/// Takes from a light what shows along a shadow ray (Eqs. 18.7, 18.8).
template <NodeLike Node>
struct DimLight {
    using Real = typename Node::Real;
    Node& node;
    Real& left;
    bool operator()(const Cell<Real>&, const Shown<Real>& shown) const noexcept {
        node.tally(Operation::multiply_add, 1);
        node.tally(Operation::compare_branch, 1);
        left = left - left * shown.opacity;
        return !(left < least_share<Real>);
    }
};

}  // namespace pxm::kernels
