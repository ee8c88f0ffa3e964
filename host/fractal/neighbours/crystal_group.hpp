// The group that the maps of neighbours generate, where it is a crystallographic one: finitely many
// turns and reflections, and a lattice of translations. The copies of a tile by it cover space
// almost everywhere equally often, as they do by a lattice, if the maps of the system are
// representatives of different classes of it [Gelbrich94].
#pragma once

#include "host/fractal/neighbours/decided.hpp"
#include "host/fractal/neighbours/neighbour_graph.hpp"

namespace pxm::host {

/// The volume that the tile's is a whole multiple of: that of a fundamental domain of the group.
/// Preconditions: the graph is finite, the system is one follow set, its attractor is connected and
/// has an inside within its subspace, the open-set condition holds, and the maps' volumes add up to
/// the whole's.
[[nodiscard]] Decided<double> crystal_cell(const exact::ExactSystem& system,
                                           const NeighbourGraph& graph);

}  // namespace pxm::host
