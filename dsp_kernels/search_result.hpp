// What a search for the first cell along a ray ends with, and what it cost.
#pragma once

#include <cstdint>

#include "dsp_kernels/cell.hpp"

namespace pxm::kernels {

/// `capped`: the search was given up at the cap on cells, or at the longest word; the cell is the
/// nearest one known by then.
enum class Outcome { miss, hit, capped };

/// What a cell shows of itself.
template <class Real>
struct Shown {
    Real opacity;       // 0: nothing, 1: it hides all behind it
    std::uint32_t map;  // 0, or the address of the map inside the cell whose colour it has
};

/// What a search has found.
template <class Real>
struct SearchResult {
    Outcome outcome = Outcome::miss;  // how it ended
    Cell<Real> cell;                  // unless the outcome is a miss
    Shown<Real> shown{Real(1), 0};    // of it
};

/// Counts of one ray (or, summed, of a node).
struct SearchCounts {
    std::uint64_t volumes_tested = 0;  // cells whose volume was intersected with the ray
    std::uint64_t heap_pushes = 0;     // cells put into the heap
    std::uint64_t heap_peak = 0;       // most cells in the heap at once
    std::uint64_t heap_overflows = 0;  // rays that dropped a cell
    std::uint64_t restarts = 0;        // rays that had to be finished by next_after
    std::uint64_t capped = 0;          // rays given up at the cap on cells or the longest word
};

}  // namespace pxm::kernels
