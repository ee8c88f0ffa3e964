// The largest mean of log Lip over the cycles of the follow sets: below zero, the system contracts
// (thesis-notes, "Singular and non-contractive maps", (a)). Howard's policy iteration finds it; the
// potentials it leaves are a certificate that does not depend on how they were found.
#pragma once

#include <vector>

#include "host/fractal/rifs.hpp"

namespace pxm::host {

struct CycleMean {
    /// No cycle's mean of log Lip is larger. For every set s and map m of s whose follow set t lies
    /// in the component of s: log Lip m + potential[t] <= bound + potential[s].
    double bound = 0;
    std::vector<double> potential;  // per follow set, largest 0 in each component
    std::vector<int> cycle;         // the worst cycle found: maps, in descent order
    double mean = 0;                // its mean of log Lip
};

/// Precondition: every map is finite, no follow set is empty.
[[nodiscard]] CycleMean largest_cycle_mean(const Rifs& rifs);

}  // namespace pxm::host
