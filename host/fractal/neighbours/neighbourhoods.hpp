// Which neighbours a cell has of those that the whole may have: the types of all cells of much its
// size, outside of the whole, that it has a common point with.
#pragma once

#include <vector>

#include "host/fractal/neighbours/neighbour_graph.hpp"
#include "host/fractal/system/rifs.hpp"

namespace pxm::host {

/// A follow set and the types that a cell of it is the first of, rising, without those of cells
/// that coincide with it.
struct Neighbourhood {
    int set = 0;
    std::vector<int> types;
    auto operator<=>(const Neighbourhood&) const = default;
};

/// All neighbours that a cell of the follow set may have. Precondition: the graph is finite.
[[nodiscard]] Neighbourhood all_around(const NeighbourGraph& graph, int set);

/// Of the cells that the maps of its follow set make, in their order.
[[nodiscard]] std::vector<Neighbourhood> smaller(const NeighbourGraph& graph, const Rifs& rifs,
                                                 const Neighbourhood& whole);

}  // namespace pxm::host
