// Into how many parts an attractor falls: at a level, cells that have a common point hang together,
// and the numbers of parts that do not never fall from one level to the next. What they come to is
// how many connected components the attractor has.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "host/fractal/neighbours/neighbour_graph.hpp"
#include "host/fractal/system/rifs.hpp"

namespace pxm::host {

struct LevelParts {
    std::vector<std::size_t> counts;    // of the levels 1, 2 ...
    std::optional<std::size_t> number;  // of the attractor's components; nothing: see `infinite`
    std::optional<bool> infinite;       // whether there is no such number; nothing: not known
    std::string why;
};

/// As far as there are at most `most` cells. Precondition: the graph is finite.
[[nodiscard]] LevelParts level_parts(const NeighbourGraph& graph, const Rifs& rifs,
                                     std::size_t most);

}  // namespace pxm::host
