// The largest mean of log Lip over the cycles of the follow sets: below zero, the system contracts
// (thesis-notes, "Singular and non-contractive maps", (a)). Howard's policy iteration finds it; the
// potentials it leaves are a certificate that does not depend on how they were found.
#pragma once

#include <vector>

#include "host/fractal/system/rifs.hpp"

namespace pxm::host {

struct CycleMean {
    /// No cycle's mean of log Lip is larger, up to rounding. For every set s and map m of s whose
    /// follow set t lies in the component of s: log Lip m + potential[t] <= bound + potential[s].
    double bound = 0;
    std::vector<double> potential;  // per follow set, largest 0 in each component
    std::vector<int> cycle;         // the worst cycle found: maps, in descent order
    double mean = 0;                // its mean of log Lip
};

/// Precondition: every map is finite, no follow set is empty.
[[nodiscard]] CycleMean largest_cycle_mean(const Rifs& rifs);

/// Positive weights for the follow sets, from the potentials.
[[nodiscard]] std::vector<double> weights_of(const CycleMean& mean);

/// A rate with Lip m weight[t] <= rate weight[s] for every set s and map m of s whose follow set t
/// lies in the component of s. So no cycle's geometric mean of Lip is larger: this is checked in
/// brackets and does not depend on where the weights come from. Infinite if they prove nothing.
[[nodiscard]] double proven_rate(const Rifs& rifs, const std::vector<double>& weight);

}  // namespace pxm::host
