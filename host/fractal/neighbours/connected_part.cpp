#include "host/fractal/neighbours/connected_part.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <utility>
#include <vector>

#include "host/fractal/neighbours/groups.hpp"

namespace pxm::host {

namespace {

/// The types with an endless path along maps of `kept` alone.
std::vector<char> endless_within(const NeighbourGraph& graph, const std::vector<char>& kept) {
    const auto within = [&](int map) { return map < 0 || kept[static_cast<std::size_t>(map)]; };
    std::vector<std::vector<std::size_t>> before(graph.types.size());
    std::vector<int> left(graph.types.size(), 0);
    for (std::size_t t = 0; t < graph.types.size(); ++t)
        for (const NeighbourEdge& e : graph.types[t].edges) {
            if (!within(e.first) || !within(e.second)) continue;
            before[static_cast<std::size_t>(e.to)].push_back(t);
            ++left[t];
        }
    std::vector<char> endless(graph.types.size(), 1);
    std::vector<std::size_t> waiting;
    for (std::size_t t = 0; t < left.size(); ++t)
        if (left[t] == 0) waiting.push_back(t);
    while (!waiting.empty()) {
        const std::size_t t = waiting.back();
        waiting.pop_back();
        endless[t] = 0;
        for (const std::size_t b : before[t])
            if (--left[b] == 0) waiting.push_back(b);
    }
    return endless;
}

/// The groups into which `group` falls by common points of its own attractor.
std::vector<std::vector<int>> groups_within(const NeighbourGraph& graph,
                                            const std::vector<int>& group, std::size_t maps) {
    std::vector<char> kept(maps, 0);
    for (const int m : group) kept[static_cast<std::size_t>(m)] = 1;
    const std::vector<char> endless = endless_within(graph, kept);
    Groups parts(maps);
    for (const NeighbourEdge& e : graph.own[0])
        if (kept[static_cast<std::size_t>(e.first)] && kept[static_cast<std::size_t>(e.second)] &&
            endless[static_cast<std::size_t>(e.to)])
            parts.join(static_cast<std::size_t>(e.first), static_cast<std::size_t>(e.second));
    std::map<std::size_t, std::vector<int>> groups;
    for (const int m : group) groups[parts.leader(static_cast<std::size_t>(m))].push_back(m);
    std::vector<std::vector<int>> result;
    for (auto& [leader, members] : groups) result.push_back(std::move(members));
    return result;
}

glm::dvec3 fixed_point(const Affine& map) {
    constexpr int most_rounds = 10'000;
    constexpr double still = 1e-12;
    glm::dvec3 p{0.0};
    for (int round = 0; round < most_rounds; ++round) {
        const glm::dvec3 next = map.point(p);
        if (glm::length(next - p) <= still * (1 + glm::length(next))) return next;
        p = next;
    }
    return p;
}

/// Whether the maps have clearly different fixed points, so that their attractor is no point.
bool spread(const Rifs& rifs, const std::vector<int>& group) {
    constexpr double clearly = 1e-6;
    const glm::dvec3 p = fixed_point(rifs.maps[static_cast<std::size_t>(group[0])]);
    return std::ranges::any_of(group, [&](int m) {
        const glm::dvec3 q = fixed_point(rifs.maps[static_cast<std::size_t>(m)]);
        return glm::length(q - p) > clearly * (1 + glm::length(p));
    });
}

}  // namespace

bool has_connected_part(const NeighbourGraph& graph, const Rifs& rifs) {
    if (graph.own.size() != 1) return false;
    // Maps that hang together by themselves lie in one group of any larger choice of maps.
    std::vector<std::vector<int>> waiting{rifs.follow_sets[0].maps};
    while (!waiting.empty()) {
        const std::vector<int> group = std::move(waiting.back());
        waiting.pop_back();
        if (group.size() < 2) continue;
        const auto groups = groups_within(graph, group, rifs.maps.size());
        if (groups.size() == 1) {
            if (spread(rifs, group)) return true;
            continue;
        }
        waiting.insert(waiting.end(), groups.begin(), groups.end());
    }
    return false;
}

}  // namespace pxm::host
