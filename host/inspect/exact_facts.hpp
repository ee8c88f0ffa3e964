// Joins what exact numbers decide (host/fractal/neighbours/) with what was measured in double:
// where both speak, exact numbers win.
#pragma once

#include <vector>

#include "host/inspect/inspection.hpp"
#include "host/scene/check/settings.hpp"

namespace pxm::host {

/// Fills facts.exact, and facts.open_set where it is decided. `part` is what the start of
/// facts.rifs leads to, with its `bounds`.
void add_exact_facts(const IfsBlock& block, const Scene* scene, const Rifs& part,
                     const std::vector<Bounds>& bounds, const NeighbourLimits& limits,
                     IfsFacts& facts);

/// What exact numbers decide of `part`, which the start of the block's `rifs` leads to.
[[nodiscard]] ExactFindings exact_findings(const IfsBlock& block, const Scene* scene,
                                           const Rifs& rifs, const Rifs& part,
                                           const std::vector<Bounds>& bounds,
                                           const NeighbourLimits& limits);

/// Whether all systems' maps still have the numbers that the text says.
[[nodiscard]] bool keep_numbers(const Settings& settings);

/// What follows for the attractor's topology, in both directions. facts.disconnected is known.
void add_exact_topology(IfsFacts& facts);

}  // namespace pxm::host
