// The volume of a tile whose neighbours are all translated copies of it. The translations of
// neighbours make a lattice; the tile's copies by the lattice cover space, almost every point
// equally often, and as often as the tile's volume is times that of a cell of the lattice [LW96].
#pragma once

#include "host/fractal/bounds/bounds.hpp"
#include "host/fractal/neighbours/decided.hpp"
#include "host/fractal/neighbours/neighbour_graph.hpp"

namespace pxm::host {

/// Preconditions: the graph is finite, the system is one follow set, its attractor has an inside
/// within its subspace, and the open-set condition holds.
[[nodiscard]] Decided<double> tile_volume(const exact::ExactSystem& system, const Rifs& rifs,
                                          const NeighbourGraph& graph, const Bounds& bounds);

}  // namespace pxm::host
