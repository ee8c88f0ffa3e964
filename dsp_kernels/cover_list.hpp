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
    static constexpr std::uint32_t capacity = 8;  // covers
    struct Entry {                                // one cover
        Cell<Real> cell;                          // that shows
        Shown<Real> shown;                        // how much of it, and in what colour
    };
    Entry entries[capacity];  // the nearest first
    std::uint32_t size = 0;   // how many there are
};

/// Fills the list with what shows, until nothing shows behind.
template <NodeLike Node>
struct CollectCovers {
    using Real = typename Node::Real;  // of the node
    Node& node;                        // that does the work
    CoverList<Real>& list;             // to be filled
    Real& left;                        // of the ray's share
    Real least;                        // below it nothing is left
    /// Takes a cell; false: no more is wanted.
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
    using Real = typename Node::Real;  // of the node
    Node& node;                        // that does the work
    Real& left;                        // of the light, 0 to 1
    /// Takes a cell; false: no light is left.
    bool operator()(const Cell<Real>&, const Shown<Real>& shown) const noexcept {
        node.tally(Operation::multiply_add, 1);
        node.tally(Operation::compare_branch, 1);
        left = left - left * shown.opacity;
        return !(left < least_share<Real>);
    }
};

}  // namespace pxm::kernels
