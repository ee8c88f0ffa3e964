#include "host/fractal/neighbours/neighbourhoods.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

namespace pxm::host {

namespace {

bool is_other(const NeighbourGraph& graph, int type) {
    const NeighbourType& t = graph.types[static_cast<std::size_t>(type)];
    return t.touches && !t.identity;
}

/// Per map: the types of what its cell is first of.
using After = std::map<int, std::vector<int>>;

/// Edges that leave the first cell whole are followed until one divides it.
void follow(const NeighbourGraph& graph, int type, After& after) {
    std::vector<int> waiting{type};
    while (!waiting.empty()) {
        const int t = waiting.back();
        waiting.pop_back();
        for (const NeighbourEdge& e : graph.types[static_cast<std::size_t>(t)].edges) {
            if (!is_other(graph, e.to)) continue;
            if (e.first < 0) {
                waiting.push_back(e.to);
            } else {
                after[e.first].push_back(e.to);
            }
        }
    }
}

}  // namespace

Neighbourhood all_around(const NeighbourGraph& graph, int set) {
    Neighbourhood all{set, {}};
    for (std::size_t t = 0; t < graph.types.size(); ++t)
        if (graph.types[t].first == set && is_other(graph, static_cast<int>(t)))
            all.types.push_back(static_cast<int>(t));
    return all;
}

std::vector<Neighbourhood> smaller(const NeighbourGraph& graph, const Rifs& rifs,
                                   const Neighbourhood& whole) {
    After after;
    for (const int t : whole.types) follow(graph, t, after);
    std::vector<Neighbourhood> result;
    for (const int m : rifs.follow_sets[static_cast<std::size_t>(whole.set)].maps) {
        std::vector<int>& types = after[m];
        std::ranges::sort(types);
        types.erase(std::unique(types.begin(), types.end()), types.end());
        result.push_back({rifs.follow_of[static_cast<std::size_t>(m)], std::move(types)});
    }
    return result;
}

}  // namespace pxm::host
