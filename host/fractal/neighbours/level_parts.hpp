// Into how many parts a disconnected attractor falls: at a level, cells that have a common point
// hang together, and the numbers of parts that do not grow with the level.
#pragma once

#include <cstddef>
#include <vector>

#include "host/fractal/neighbours/neighbour_graph.hpp"
#include "host/fractal/system/rifs.hpp"

namespace pxm::host {

/// Of the levels 1, 2 ...: how many parts the cells of so many maps make, where those with a common
/// point are one part. As far as there are at most `most` cells, and ten times as many pairs of
/// them. Precondition: the graph is finite.
[[nodiscard]] std::vector<std::size_t> level_parts(const NeighbourGraph& graph, const Rifs& rifs,
                                                   std::size_t most);

/// Whether some maps of a system of one follow set have an attractor of their own that is connected
/// and no point, so that the whole is not totally disconnected. False says nothing.
[[nodiscard]] bool has_connected_part(const NeighbourGraph& graph, const Rifs& rifs);

}  // namespace pxm::host
