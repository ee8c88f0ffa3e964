// The volume of a tile. Where its neighbours are translated copies of it, their translations make a
// lattice; the tile's copies by the lattice cover space, almost every point equally often, and as
// often as the tile's volume is times that of a cell of the lattice [LW96]. Where they are turned
// as well, a crystallographic group may do the same (crystal_group.hpp). How often is a whole
// number that two bounds of the volume decide.
#pragma once

#include "host/fractal/bounds/bounds.hpp"
#include "host/fractal/neighbours/decided.hpp"
#include "host/fractal/neighbours/neighbour_graph.hpp"
#include "host/fractal/neighbours/volume_bracket.hpp"

namespace pxm::host {

struct TileVolume {
    Decided<double> value;
    std::optional<VolumeBracket> between;  // if it is not decided
};

/// Preconditions: the graph is finite, the attractor has an inside within its subspace, the
/// open-set condition holds, and the maps' volumes add up to the whole's.
[[nodiscard]] TileVolume tile_volume(const exact::ExactSystem& system, const Rifs& rifs,
                                     const NeighbourGraph& graph, const std::vector<Bounds>& bounds,
                                     bool connected);

}  // namespace pxm::host
