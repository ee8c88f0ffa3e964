#include "host/fractal/system/graph_facts.hpp"

#include <algorithm>
#include <utility>

#include "host/fractal/system/components.hpp"

namespace pxm::host {

namespace {

/// Per follow set, whether the start leads to it.
std::vector<char> reached_sets(const Rifs& rifs) {
    std::vector<char> reached(rifs.follow_sets.size(), 0);
    std::vector<int> waiting{rifs.start};
    reached[rifs.start] = 1;
    while (!waiting.empty()) {
        const int set = waiting.back();
        waiting.pop_back();
        for (const int m : rifs.follow_sets[set].maps) {
            if (std::exchange(reached[rifs.follow_of[m]], char{1})) continue;
            waiting.push_back(rifs.follow_of[m]);
        }
    }
    return reached;
}

std::vector<char> reached_maps(const Rifs& rifs) {
    const std::vector<char> sets = reached_sets(rifs);
    std::vector<char> maps(rifs.maps.size(), 0);
    for (std::size_t s = 0; s < sets.size(); ++s) {
        if (!sets[s]) continue;
        for (const int m : rifs.follow_sets[s].maps) maps[m] = 1;
    }
    return maps;
}

/// The edges between components; of the maps with one follow set and one component, the first
/// speaks for all.
void add_condensation(const Rifs& rifs, GraphFacts& facts) {
    std::vector<int> component(rifs.maps.size(), 0);
    for (std::size_t c = 0; c < facts.components.size(); ++c) {
        for (const int m : facts.components[c]) component[m] = static_cast<int>(c);
    }
    facts.recurrent.assign(facts.components.size(), 0);
    std::vector<std::vector<int>> leads_to(rifs.follow_sets.size());  // components, per follow set
    for (std::size_t s = 0; s < leads_to.size(); ++s) {
        for (const int m : rifs.follow_sets[s].maps) leads_to[s].push_back(component[m]);
        std::ranges::sort(leads_to[s]);
        leads_to[s].erase(std::unique(leads_to[s].begin(), leads_to[s].end()), leads_to[s].end());
    }
    std::vector<std::pair<int, int>> seen;  // component and follow set
    for (std::size_t m = 0; m < rifs.maps.size(); ++m) {
        seen.emplace_back(component[m], rifs.follow_of[m]);
    }
    std::ranges::sort(seen);
    seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
    for (const auto& [from, set] : seen) {
        for (const int to : leads_to[set]) {
            if (to == from) facts.recurrent[from] = 1;
            if (to != from) facts.condensation.push_back({from, to});
        }
    }
    const auto order = [](const ComponentEdge& e) { return std::pair(e.from, e.to); };
    std::ranges::sort(facts.condensation, {}, order);
    facts.condensation.erase(std::unique(facts.condensation.begin(), facts.condensation.end()),
                             facts.condensation.end());
}

}  // namespace

GraphFacts graph_facts(const Rifs& rifs) {
    GraphFacts facts;
    facts.start = rifs.follow_sets[rifs.start].maps;
    const std::vector<char> reached = reached_maps(rifs);
    facts.complete = true;
    for (std::size_t m = 0; m < rifs.maps.size(); ++m) {
        const std::size_t followers = rifs.follow_sets[rifs.follow_of[m]].maps.size();
        if (!reached[m]) facts.unreachable.push_back(static_cast<int>(m));
        if (followers == 0) facts.dead_ends.push_back(static_cast<int>(m));
        facts.complete = facts.complete && followers == rifs.maps.size();
    }
    facts.components = strong_components(rifs);
    facts.strongly_connected = facts.components.size() == 1;
    add_condensation(rifs, facts);
    return facts;
}

Rifs reachable_part(const Rifs& rifs) {
    const std::vector<char> sets = reached_sets(rifs);
    const std::vector<char> maps = reached_maps(rifs);
    std::vector<int> new_set(sets.size(), -1);
    std::vector<int> new_map(maps.size(), -1);
    Rifs part;
    part.name = rifs.name;
    int count = 0;
    for (std::size_t s = 0; s < sets.size(); ++s) {
        if (sets[s]) new_set[s] = count++;
    }
    for (std::size_t m = 0; m < maps.size(); ++m) {
        if (!maps[m]) continue;
        new_map[m] = static_cast<int>(part.maps.size());
        part.maps.push_back(rifs.maps[m]);
        part.map_names.push_back(rifs.map_names[m]);
        part.follow_of.push_back(new_set[rifs.follow_of[m]]);
    }
    for (std::size_t s = 0; s < sets.size(); ++s) {
        if (!sets[s]) continue;
        FollowSet& set = part.follow_sets.emplace_back();
        for (const int m : rifs.follow_sets[s].maps) set.maps.push_back(new_map[m]);
    }
    part.start = new_set[rifs.start];
    return part;
}

RecurrentPart recurrent_part(const Rifs& rifs) {
    const std::vector<int> component = set_components(rifs);
    RecurrentPart part;
    part.rifs.name = rifs.name;
    std::vector<int> new_set(rifs.follow_sets.size(), -1);
    for (std::size_t s = 0; s < rifs.follow_sets.size(); ++s) {
        const auto stays = [&](int m) { return component[rifs.follow_of[m]] == component[s]; };
        if (std::ranges::none_of(rifs.follow_sets[s].maps, stays)) continue;
        new_set[s] = static_cast<int>(part.sets.size());
        part.sets.push_back(static_cast<int>(s));
    }
    std::vector<int> new_map(rifs.maps.size(), -1);
    for (const int s : part.sets) {
        FollowSet& set = part.rifs.follow_sets.emplace_back();
        for (const int m : rifs.follow_sets[s].maps) {
            if (component[rifs.follow_of[m]] != component[s]) continue;
            if (new_map[m] < 0) {
                new_map[m] = static_cast<int>(part.rifs.maps.size());
                part.rifs.maps.push_back(rifs.maps[m]);
                part.rifs.map_names.push_back(rifs.map_names[m]);
                part.rifs.follow_of.push_back(new_set[rifs.follow_of[m]]);
            }
            set.maps.push_back(new_map[m]);
        }
    }
    return part;
}

}  // namespace pxm::host
