// What the graph of a system looks like (Sec. 4.3, 7.2.2): reachable maps, strongly connected
// components, and the condensation, the graph between them.
#pragma once

#include <vector>

#include "host/fractal/system/rifs.hpp"

namespace pxm::host {

/// An edge of the condensation, from a component to a later one; indices into components.
struct ComponentEdge {
    int from = 0;  // the earlier one
    int to = 0;    // the later one
    bool operator==(const ComponentEdge&) const = default;
};

struct GraphFacts {                            // what is known of a graph
    std::vector<int> start;                    // maps that may come first
    std::vector<int> unreachable;              // maps that no start map leads to
    std::vector<int> dead_ends;                // maps that nothing may follow
    std::vector<std::vector<int>> components;  // of maps; edges lead to later ones
    std::vector<char> recurrent;               // per component: a map of it may come again
    std::vector<ComponentEdge> condensation;   // each once, sorted
    bool complete = false;                     // any map may follow any other
    bool strongly_connected = false;           // every start map leads to every other map and back
};

[[nodiscard]] GraphFacts graph_facts(const Rifs& rifs);  // looks at the whole graph

/// The part of a system that its start leads to: what the attractor depends on.
[[nodiscard]] Rifs reachable_part(const Rifs& rifs);

/// What may come again and again: the follow sets that a cycle passes, each with the maps that lead
/// to its own strongly connected component. The start is the first of them.
struct RecurrentPart {
    Rifs rifs;              // without maps and follow sets if there is no cycle
    std::vector<int> sets;  // per follow set of it: which one it is of the whole
};
/// Finds it; without a cycle it is empty.
[[nodiscard]] RecurrentPart recurrent_part(const Rifs& rifs);

}  // namespace pxm::host
