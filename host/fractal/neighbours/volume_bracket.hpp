// Two volumes that the attractor's lies between. Boxes of a grid that no cell at the boundary comes
// near are inside or outside as a whole, each together with those that it shares a side with.
#pragma once

#include <optional>

#include "host/fractal/bounds/bounds.hpp"
#include "host/fractal/neighbours/neighbour_graph.hpp"
#include "host/fractal/neighbours/volume_range.hpp"

namespace pxm::host {

/// Of E_start. Nothing if the subspace is aslant, or the boundary has too many cells.
/// Preconditions: the graph is finite, E_start has an inside within its subspace, and some cell of
/// the whole that is like it is in the inside of the whole.
[[nodiscard]] std::optional<VolumeBracket> volume_bracket(const exact::ExactSystem& system,
                                                          const Rifs& rifs,
                                                          const NeighbourGraph& graph,
                                                          const std::vector<Bounds>& bounds);

}  // namespace pxm::host
