#include "host/fractal/neighbours/distinct_words.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace pxm::host {

namespace {

/// Types from which the identity is reached.
std::vector<char> reaching_identity(const NeighbourGraph& graph) {
    std::vector<std::vector<int>> before(graph.types.size());
    std::vector<char> reaches(graph.types.size(), 0);
    std::vector<int> waiting;
    for (std::size_t t = 0; t < graph.types.size(); ++t) {
        for (const NeighbourEdge& e : graph.types[t].edges)
            before[static_cast<std::size_t>(e.to)].push_back(static_cast<int>(t));
        if (!graph.types[t].identity) continue;
        reaches[t] = 1;
        waiting.push_back(static_cast<int>(t));
    }
    while (!waiting.empty()) {
        const int t = waiting.back();
        waiting.pop_back();
        for (const int b : before[static_cast<std::size_t>(t)])
            if (!std::exchange(reaches[static_cast<std::size_t>(b)], char{1})) waiting.push_back(b);
    }
    return reaches;
}

/// How earlier words lie against a word: the follow set of what stands in it, and the types.
struct Place {
    int set = 0;
    std::vector<int> types;
    auto operator<=>(const Place&) const = default;
};

}  // namespace

std::optional<DistinctWords> distinct_words(const NeighbourGraph& graph, const Rifs& rifs,
                                            std::size_t most) {
    const std::vector<char> reaches = reaching_identity(graph);
    std::map<Place, int> numbers;
    std::vector<const Place*> places;
    const auto number_of = [&](Place place) {
        const auto [found, added] =
            numbers.emplace(std::move(place), static_cast<int>(numbers.size()));
        if (added) places.push_back(&found->first);
        return found->second;
    };
    number_of({rifs.start, {}});
    DistinctWords words;
    for (std::size_t s = 0; s < places.size(); ++s) {
        if (places.size() > most) return std::nullopt;
        const Place& place = *places[s];
        std::map<int, std::vector<int>> after;  // per map: the types
        const auto add = [&](const NeighbourEdge& e) {
            if (reaches[static_cast<std::size_t>(e.to)]) after[e.second].push_back(e.to);
        };
        for (const int t : place.types)
            for (const NeighbourEdge& e : graph.types[static_cast<std::size_t>(t)].edges) add(e);
        for (const NeighbourEdge& e : graph.own[static_cast<std::size_t>(place.set)])
            if (e.first < e.second) add(e);
        auto& steps = words.states.emplace_back();
        for (const int m : rifs.follow_sets[static_cast<std::size_t>(place.set)].maps) {
            std::vector<int>& types = after[m];
            const bool equal = std::ranges::any_of(
                types, [&](int t) { return graph.types[static_cast<std::size_t>(t)].identity; });
            if (equal) continue;
            std::ranges::sort(types);
            types.erase(std::unique(types.begin(), types.end()), types.end());
            steps.push_back({m, number_of({rifs.follow_of[static_cast<std::size_t>(m)], types})});
        }
    }
    return words;
}

}  // namespace pxm::host
