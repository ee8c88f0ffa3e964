// Strongly connected components of the graph of maps and follow sets (Sec. 7.2.2).
// A map leads to its follow set and a follow set to its maps, so that a complete graph over N maps
// has 2N edges, not N * N.
#pragma once

#include <vector>

#include "host/fractal/system/rifs.hpp"

namespace pxm::host {

/// A directed graph in rows: vertex v leads to targets[first[v]] .. targets[first[v + 1] - 1].
struct Graph {
    std::vector<int> first;
    std::vector<int> targets;
    [[nodiscard]] int size() const { return static_cast<int>(first.size()) - 1; }
};

/// The descent graph: vertices 0 .. N-1 are the maps, N + s is follow set s.
[[nodiscard]] Graph descent_graph(const Rifs& rifs);

/// The component of each vertex. Edges between components lead from lower to higher numbers.
[[nodiscard]] std::vector<int> component_numbers(const Graph& graph);

/// The component of each follow set. Edges lead from lower or equal to higher or equal numbers.
[[nodiscard]] std::vector<int> set_components(const Rifs& rifs);

}  // namespace pxm::host
