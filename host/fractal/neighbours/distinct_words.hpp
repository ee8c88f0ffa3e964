// Where words are the same map: the graph-directed system of the words that no earlier word
// equals, and the Hausdorff dimension that it gives [Zerner96] [NW01].
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/fractal/neighbours/graph_growth.hpp"
#include "host/fractal/neighbours/neighbour_graph.hpp"

namespace pxm::host {

/// A state for each way in which earlier words may still become equal to a word. From it, the maps
/// that make the word longer so that no earlier word equals it.
struct DistinctWords {
    struct Step {
        int map = 0;
        int to = 0;
    };
    std::vector<std::vector<Step>> states;  // the first is that of the empty word
};

/// Words are compared by the maps' numbers. Nothing if there are more than `most` states.
/// Precondition: the graph is finite, and both cells of every pair were always divided at once.
[[nodiscard]] std::optional<DistinctWords> distinct_words(const NeighbourGraph& graph,
                                                          const Rifs& rifs, std::size_t most);

}  // namespace pxm::host
