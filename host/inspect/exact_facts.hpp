// Joins what exact numbers decide (host/fractal/neighbours/) with what was measured in double:
// where both speak, exact numbers win.
#pragma once

#include <vector>

#include "host/inspect/inspection.hpp"

namespace pxm::host {

/// Fills facts.exact, and facts.open_set where it is decided. `part` is what the start of
/// facts.rifs leads to, with its `bounds`.
void add_exact_facts(const IfsBlock& block, const Scene* scene, const Rifs& part,
                     const std::vector<Bounds>& bounds, const NeighbourLimits& limits,
                     IfsFacts& facts);

/// What follows for the attractor's topology, in both directions. facts.disconnected is known.
void add_exact_topology(IfsFacts& facts);

}  // namespace pxm::host
