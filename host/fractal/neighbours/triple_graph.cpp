#include "host/fractal/neighbours/triple_graph.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

namespace pxm::host {

namespace {

constexpr std::array<std::array<int, 3>, 6> orders{
    {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};

/// The place of the pair (a, b) or (b, a) among (0, 1), (0, 2), (1, 2).
std::size_t pair_place(int a, int b) { return static_cast<std::size_t>(a + b - 1); }

class Triples {
  public:
    Triples(const NeighbourGraph& graph, std::size_t most)
        : graph_(graph),
          most_(most),
          reversed_(graph.types.size(), -1),
          by_maps_(reversed_.size()) {
        for (std::size_t t = 0; t < by_maps_.size(); ++t)
            by_maps_[t] = by_maps(graph.types[t].edges);
        reverse();
    }

    TripleGraph run() {
        for (const auto& own : graph_.own) begin_with_three(own);
        for (std::size_t t = 0; t < graph_.types.size() && found_.types.size() <= most_; ++t)
            begin_with_two(t);
        for (std::size_t k = 0; k < found_.types.size(); ++k) {
            if (found_.types.size() > most_) {
                found_.why = fmt::format("more than {} triples", most_);
                found_.types.clear();
                return std::move(found_);
            }
            divide(k);
            if (!found_.why.empty()) return std::move(found_);
        }
        remove_dead_ends();
        found_.complete = true;
        return std::move(found_);
    }

  private:
    using ByMaps = std::map<std::pair<int, int>, int>;

    static ByMaps by_maps(const std::vector<NeighbourEdge>& edges) {
        ByMaps result;
        for (const NeighbourEdge& e : edges) result[{e.first, e.second}] = e.to;
        return result;
    }

    /// The type of the same two cells, the second first. Both follow the same steps.
    void reverse() {
        std::vector<int> waiting;
        const auto pair_up = [&](const ByMaps& one, const ByMaps& other) {
            for (const auto& [maps, to] : one) {
                const auto found = other.find({maps.second, maps.first});
                if (found == other.end() || reversed_[static_cast<std::size_t>(to)] >= 0) continue;
                reversed_[static_cast<std::size_t>(to)] = found->second;
                waiting.push_back(to);
            }
        };
        for (const auto& edges : graph_.own) {
            const ByMaps own = by_maps(edges);
            pair_up(own, own);
        }
        while (!waiting.empty()) {
            const auto t = static_cast<std::size_t>(waiting.back());
            waiting.pop_back();
            pair_up(by_maps_[t], by_maps_[static_cast<std::size_t>(reversed_[t])]);
        }
    }

    [[nodiscard]] bool different(int type) const {
        const auto t = static_cast<std::size_t>(type);
        return graph_.types[t].touches && !graph_.types[t].identity && reversed_[t] >= 0;
    }

    int number_of(const std::array<int, 3>& pairs) {
        const auto [place, added] = numbers_.emplace(pairs, static_cast<int>(found_.types.size()));
        if (added) found_.types.push_back({pairs, {}});
        return place->second;
    }

    /// All orders of the three.
    void begin(const std::array<int, 3>& pairs) {
        if (!std::ranges::all_of(pairs, [&](int t) { return different(t); })) return;
        for (const auto& order : orders) {
            std::array<int, 3> ordered{};
            for (int a = 0; a < 3; ++a)
                for (int b = a + 1; b < 3; ++b) {
                    const int x = order[static_cast<std::size_t>(a)];
                    const int y = order[static_cast<std::size_t>(b)];
                    const int type = pairs[pair_place(x, y)];
                    ordered[pair_place(a, b)] =
                        x < y ? type : reversed_[static_cast<std::size_t>(type)];
                }
            number_of(ordered);
        }
    }

    /// Three maps of one follow set.
    void begin_with_three(const std::vector<NeighbourEdge>& edges) {
        const ByMaps own = by_maps(edges);
        for (const auto& [first, a] : own)
            for (auto second = own.lower_bound({first.first, first.second + 1});
                 second != own.end() && second->first.first == first.first; ++second) {
                const auto third = own.find({first.second, second->first.second});
                if (third != own.end()) begin({a, second->second, third->second});
            }
    }

    /// Two smaller cells of the first of two neighbours, and the second or one of its.
    void begin_with_two(std::size_t t) {
        const NeighbourType& type = graph_.types[t];
        if (!different(static_cast<int>(t)) || !divides(t, 0)) return;
        for (const NeighbourEdge& e : graph_.own[static_cast<std::size_t>(type.first)]) {
            if (e.first > e.second) continue;
            auto one = by_maps_[t].lower_bound({e.first, -1});
            for (; one != by_maps_[t].end() && one->first.first == e.first; ++one) {
                const auto other = by_maps_[t].find({e.second, one->first.second});
                if (other != by_maps_[t].end()) begin({e.to, one->second, other->second});
            }
        }
    }

    /// Whether the first (0) or second (1) cell of a type is divided: the larger is, or both are.
    [[nodiscard]] bool divides(std::size_t type, int which) const {
        const auto& edges = graph_.types[type].edges;
        return !edges.empty() && (which == 0 ? edges[0].first : edges[0].second) >= 0;
    }

    /// Whether dividing the largest cells divides each pair as the graph does, or not at all.
    [[nodiscard]] bool divisible(const std::array<int, 3>& pairs,
                                 const std::array<bool, 3>& largest) const {
        bool any = false;
        for (int a = 0; a < 3; ++a)
            for (int b = a + 1; b < 3; ++b) {
                const auto type = static_cast<std::size_t>(pairs[pair_place(a, b)]);
                const bool first = largest[static_cast<std::size_t>(a)];
                const bool second = largest[static_cast<std::size_t>(b)];
                if (!first && !second) continue;
                any = true;
                if (divides(type, 0) != first || divides(type, 1) != second) return false;
            }
        return any;
    }

    void divide(std::size_t k) {
        const std::array<int, 3> pairs = found_.types[k].pairs;
        std::array<bool, 3> largest{true, true, true};
        for (int a = 0; a < 3; ++a)
            for (int b = a + 1; b < 3; ++b) {
                const auto type = static_cast<std::size_t>(pairs[pair_place(a, b)]);
                if (!divides(type, 0)) largest[static_cast<std::size_t>(a)] = false;
                if (!divides(type, 1)) largest[static_cast<std::size_t>(b)] = false;
            }
        if (!divisible(pairs, largest)) {
            found_.why = "the sizes of three cells are too near to each other";
            found_.types.clear();
            return;
        }
        std::array<ByMaps, 3> steps;
        for (int a = 0; a < 3; ++a)
            for (int b = a + 1; b < 3; ++b) {
                const std::size_t place = pair_place(a, b);
                const auto type = static_cast<std::size_t>(pairs[place]);
                steps[place] =
                    largest[static_cast<std::size_t>(a)] || largest[static_cast<std::size_t>(b)]
                        ? by_maps_[type]
                        : ByMaps{{{-1, -1}, pairs[place]}};
            }
        std::vector<TripleEdge> edges;
        for (const auto& [first, a] : steps[0])
            for (auto second = steps[1].lower_bound({first.first, -1});
                 second != steps[1].end() && second->first.first == first.first; ++second) {
                const auto third = steps[2].find({first.second, second->first.second});
                if (third == steps[2].end()) continue;
                const std::array<int, 3> next{a, second->second, third->second};
                if (!std::ranges::all_of(next, [&](int t) { return different(t); })) continue;
                edges.push_back(
                    {{first.first, first.second, second->first.second}, number_of(next)});
            }
        found_.types[k].edges = std::move(edges);
    }

    /// Keeps what an endless path begins at.
    void remove_dead_ends() {
        std::vector<TripleType>& types = found_.types;
        std::vector<std::vector<int>> before(types.size());
        std::vector<std::size_t> left(types.size());
        std::vector<int> waiting, number(types.size(), 0);
        for (std::size_t k = 0; k < types.size(); ++k) {
            for (const TripleEdge& e : types[k].edges)
                before[static_cast<std::size_t>(e.to)].push_back(static_cast<int>(k));
            left[k] = types[k].edges.size();
            if (left[k] == 0) waiting.push_back(static_cast<int>(k));
        }
        while (!waiting.empty()) {
            const auto k = static_cast<std::size_t>(waiting.back());
            waiting.pop_back();
            number[k] = -1;
            for (const int b : before[k])
                if (--left[static_cast<std::size_t>(b)] == 0) waiting.push_back(b);
        }
        std::vector<TripleType> kept;
        for (std::size_t k = 0; k < types.size(); ++k) {
            if (number[k] < 0) continue;
            number[k] = static_cast<int>(kept.size());
            kept.push_back(std::move(types[k]));
        }
        for (TripleType& type : kept) {
            std::erase_if(type.edges, [&](const TripleEdge& e) {
                return number[static_cast<std::size_t>(e.to)] < 0;
            });
            for (TripleEdge& e : type.edges) e.to = number[static_cast<std::size_t>(e.to)];
        }
        types = std::move(kept);
    }

    const NeighbourGraph& graph_;
    std::size_t most_;
    std::vector<int> reversed_;
    std::vector<ByMaps> by_maps_;
    std::map<std::array<int, 3>, int> numbers_;
    TripleGraph found_;
};

}  // namespace

TripleGraph triple_graph(const NeighbourGraph& graph, std::size_t most) {
    return Triples(graph, most).run();
}

}  // namespace pxm::host
