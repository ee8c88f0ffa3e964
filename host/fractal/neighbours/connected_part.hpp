// Some maps of a system whose own attractor is connected, so that the whole is not a dust.
#pragma once

#include "host/fractal/neighbours/neighbour_graph.hpp"
#include "host/fractal/system/rifs.hpp"

namespace pxm::host {

/// Whether some maps of a system of one follow set have an attractor of their own that is connected
/// and no point, so that the whole is not totally disconnected. False says nothing.
[[nodiscard]] bool has_connected_part(const NeighbourGraph& graph, const Rifs& rifs);

}  // namespace pxm::host
