// One grid for all cells of an object: every cell's children are boxes of the same size, in the
// same slices along each axis, so that which of the places hold a child is all that sets differ in:
// a bit for each place. Menger's sponge and its kin; a graph too, if only the places that are left
// out depend on what came before. Rays that have come to different cells can walk side by side
// then, one in each lane of a register (host/wide/search/grid_lanes.inl).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "host/wide/tables/child_grid.hpp"

namespace pxm::host::wide {

struct WideSet;

/// Places are numbered as a ray comes to them: along each axis from the slice where it enters the
/// cell, x first. Which number a place has therefore depends on the *octant* of the ray: bit k is
/// set if it moves toward the low end of axis k.
struct CommonGrid {
    static constexpr int most_places = 32;  // a bit each
    static constexpr int octants = 8;

    std::array<int, 3> slices{};
    std::array<std::array<float, ChildGrid::most_slices + 1>, 3> planes{};  // as in ChildGrid
    std::array<std::array<float, ChildGrid::most_slices>, 3> centers{};     // of the slices
    std::array<std::int32_t, 3> steps{};  // from a place to that in the next slice of an axis
    /// The places that are in slice i of an axis or behind it, as a ray comes to them.
    std::array<std::array<std::int32_t, ChildGrid::most_slices>, 3> from_slice{};
    float scale = 0;                      // of a child to its cell
    float constant = 0;                   // of its map
    float diameter = 0;                   // the same times that of its volume
    std::vector<int> sets;                // those of the object, as WideScene counts them
    std::vector<std::uint32_t> occupied;  // of each of the sets, seen in each octant
    std::vector<std::int32_t> lanes;      // of the child at each place, for each of those; -1: none
    std::vector<std::int32_t> next;       // the child's set, as counted here

    /// Where what belongs to a set seen in an octant stands in `occupied`.
    [[nodiscard]] static std::size_t row(int set, int octant) {
        return static_cast<std::size_t>(set * octants + octant);
    }
    /// Where what belongs to a place stands in `lanes` and `next`.
    [[nodiscard]] static std::size_t entry(int set, int octant, int place) {
        return row(set, octant) * most_places + static_cast<std::size_t>(place);
    }
    /// The number here of a set that is the object's.
    [[nodiscard]] int number_of(int set) const;
};

/// The common grid of a set and of all that follow it; one without sets if they have none.
/// Precondition: all of them have grids.
[[nodiscard]] CommonGrid find_common_grid(std::span<const WideSet> sets, int first);

}  // namespace pxm::host::wide
