// The neighbour maps of a system in exact numbers: f_u^-1 f_v for all pairs of cells of much the
// same size that have a point in common. Where there are finitely many, they and what each becomes
// inside smaller cells are a finite graph, from which follows how the pieces meet [BG92] [DE05]
// [BM09]. Pairs are kept unless balls that contain them are proven to be apart; once the graph is
// closed, types that lead nowhere are removed, and each of the rest has a common point: cells along
// an endless path shrink to one.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "host/fractal/bounds/bounds.hpp"
#include "host/fractal/exact/exact_system.hpp"
#include "host/fractal/neighbours/neighbour_limits.hpp"
#include "host/fractal/system/rifs.hpp"

namespace pxm::host {

/// From a pair of cells to one of smaller cells in it; -1: that cell was not divided.
struct NeighbourEdge {
    int first = -1;   // the map within the first cell
    int second = -1;  // and within the second
    int to = 0;       // a type
};

/// The piece E_first against map(E_second).
struct NeighbourType {
    int first = 0;  // follow sets
    int second = 0;
    exact::ExactMap map;
    bool identity = false;
    bool touches = true;  // false: it leads nowhere
    std::vector<NeighbourEdge> edges;
    int from = -1;       // the type that it was first found in; -1: a follow set's own pair
    int first_map = -1;  // the edge that led to it
    int second_map = -1;
};

struct NeighbourGraph {
    std::vector<NeighbourType> types;
    std::vector<std::vector<NeighbourEdge>> own;  // per follow set: pairs of its different maps
    std::optional<bool> finite;                   // false: not within the limits
    std::string why;                              // if it is not, or was not searched
};

/// `bounds` as from bound(). Precondition: every follow set is reached from the start.
[[nodiscard]] NeighbourGraph neighbour_graph(const exact::ExactSystem& system, const Rifs& rifs,
                                             const std::vector<Bounds>& bounds,
                                             const NeighbourLimits& limits);

/// The words, outermost map first, by which a type was first found.
struct WordPair {
    std::vector<int> first;
    std::vector<int> second;
};
[[nodiscard]] WordPair words_of(const NeighbourGraph& graph, std::size_t type);

}  // namespace pxm::host
