#include "host/fractal/neighbours/level_parts.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

#include "host/fractal/neighbours/groups.hpp"

namespace pxm::host {

namespace {

using Word = std::vector<int>;

/// Two words, each at least as long as the level, whose cells have a common point.
struct Pair {
    Word first;
    Word second;
    int type = 0;
};

class Levels {
  public:
    Levels(const NeighbourGraph& graph, const Rifs& rifs, std::size_t most)
        : graph_(graph), rifs_(rifs), most_(most) {}

    std::vector<std::size_t> run() {
        std::vector<std::size_t> counts;
        for (std::size_t level = 1; level <= most_level && next(level); ++level)
            counts.push_back(parts());
        return counts;
    }

  private:
    static constexpr std::size_t most_level = 20;
    static constexpr std::size_t pairs_a_cell = 10;

    [[nodiscard]] std::size_t set_of(const Word& word) const {
        return static_cast<std::size_t>(
            word.empty() ? rifs_.start : rifs_.follow_of[static_cast<std::size_t>(word.back())]);
    }

    /// The cells of the level and the pairs of them that touch; false if they are too many.
    bool next(std::size_t level) {
        std::vector<Word> cells;
        std::vector<Pair> waiting = std::move(pairs_);
        pairs_.clear();
        for (const Word& cell : cells_) {
            const std::size_t set = set_of(cell);
            for (const int m : rifs_.follow_sets[set].maps) {
                cells.push_back(cell);
                cells.back().push_back(m);
            }
            for (const NeighbourEdge& e : graph_.own[set])
                if (e.first < e.second) waiting.push_back(longer({cell, cell, 0}, e));
            if (cells.size() > most_) return false;
        }
        cells_ = std::move(cells);
        while (!waiting.empty()) {
            if (pairs_.size() + waiting.size() > pairs_a_cell * most_) return false;
            const Pair pair = std::move(waiting.back());
            waiting.pop_back();
            if (pair.first.size() >= level && pair.second.size() >= level) {
                pairs_.push_back(pair);
                continue;
            }
            for (const NeighbourEdge& e : graph_.types[static_cast<std::size_t>(pair.type)].edges)
                waiting.push_back(longer(pair, e));
        }
        return true;
    }

    static Pair longer(Pair pair, const NeighbourEdge& e) {
        if (e.first >= 0) pair.first.push_back(e.first);
        if (e.second >= 0) pair.second.push_back(e.second);
        pair.type = e.to;
        return pair;
    }

    [[nodiscard]] std::size_t parts() const {
        const std::size_t level = cells_.front().size();
        std::map<Word, std::size_t> number;
        for (const Word& cell : cells_) number.emplace(cell, number.size());
        const auto cell_of = [&](Word word) {
            word.resize(level);
            return number.at(word);
        };
        Groups parts(cells_.size());
        for (const Pair& pair : pairs_) parts.join(cell_of(pair.first), cell_of(pair.second));
        return parts.count();
    }

    const NeighbourGraph& graph_;
    const Rifs& rifs_;
    std::size_t most_;
    std::vector<Word> cells_{Word{}};
    std::vector<Pair> pairs_;
};

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

std::vector<std::size_t> level_parts(const NeighbourGraph& graph, const Rifs& rifs,
                                     std::size_t most) {
    return Levels(graph, rifs, most).run();
}

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
