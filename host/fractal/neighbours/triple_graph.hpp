// Where cells meet in threes: triples of different cells of much the same size with a common point,
// up to what moves all three. Nothing new is computed in exact numbers: three cells have a common
// point exactly if they can be divided for ever so that each two of them touch, for then all three
// shrink to one point [BM09].
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "host/fractal/neighbours/neighbour_graph.hpp"

namespace pxm::host {

/// From three cells to three smaller ones in them; -1: that cell was not divided.
struct TripleEdge {
    std::array<int, 3> maps{-1, -1, -1};
    int to = 0;
};

/// Types of neighbours: of the first and the second cell, the first and the third, the second and
/// the third.
struct TripleType {
    std::array<int, 3> pairs{};
    std::vector<TripleEdge> edges;
};

struct TripleGraph {
    std::vector<TripleType> types;  // each order of the three is one
    bool complete = false;
    std::string why;  // if it is not

    /// How many pairs of neighbours meet at a point of their cell, over all such pairs that occur.
    [[nodiscard]] std::size_t count() const { return types.size() / 2; }
};

/// Precondition: the graph is finite. Cells that coincide are no different cells.
[[nodiscard]] TripleGraph triple_graph(const NeighbourGraph& graph, std::size_t most);

}  // namespace pxm::host
