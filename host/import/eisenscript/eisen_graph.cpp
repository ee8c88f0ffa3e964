#include "host/import/eisenscript/eisen_graph.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <random>
#include <tuple>
#include <utility>

#include "host/import/eisenscript/eisen_color.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {
namespace {

using Counters = std::map<std::pair<std::string, std::size_t>, long>;  // of rules with a maxdepth

/// What decides how the application of a rule goes on.
struct Application {
    std::string rule;
    long generation = 0;
    Counters counters;
    EisenColor color;
};

auto key_of(const Application& a) {
    return std::tuple(a.rule, a.generation, a.counters, a.color.hue, a.color.saturation,
                      a.color.value);
}
using Key = decltype(key_of(Application{}));

EisenShape shape_of(const std::string& name) {
    const std::string bare = name.substr(0, name.find("::"));  // the rest is its material
    if (bare == "box") return EisenShape::box;
    if (bare == "sphere") return EisenShape::sphere;
    return EisenShape::none;
}

/// The edges of a box, without faces.
bool is_grid(const std::string& name) { return name.substr(0, name.find("::")) == "grid"; }

class GraphBuilder {
  public:
    GraphBuilder(const EisenScript& script, EisenColors colors, std::uint64_t seed,
                 std::size_t most_edges)
        : script_(script), colors_(colors), random_(seed), most_edges_(most_edges) {}

    EisenGraph build() {
        graph_.colored = colors_ == EisenColors::kept;
        graph_.nodes.emplace_back();
        waiting_.push_back({"", 0, {}, {}});
        for (std::size_t i = 0; i < waiting_.size(); ++i) apply(i);
        prune();
        count();
        return std::move(graph_);
    }

  private:
    void apply(std::size_t number) {
        Application a = waiting_[number];
        if (number == 0) return act(number, script_.start, a);
        if (a.generation >= script_.max_depth) return;
        for (int retired = 0;; ++retired) {
            const std::vector<EisenRule>& rules = script_.rules.at(a.rule);
            const std::size_t one = rules.size() == 1 ? 0 : drawn(rules);
            const EisenRule& rule = rules[one];
            if (!rule.max_depth) return act(number, rule.actions, a);
            const auto counter = a.counters.emplace(std::pair(a.rule, one), *rule.max_depth).first;
            if (counter->second > 0) {
                --counter->second;
                return act(number, rule.actions, a);
            }
            if (rule.retirement.empty()) return;
            counter->second = *rule.max_depth;
            if (retired > 100) throw EisenTooMany{a.rule};
            a.rule = rule.retirement;
            if (const EisenShape shape = shape_of(a.rule);
                shape != EisenShape::none && !script_.rules.contains(a.rule))
                return add(number, {Affine{}, shape, 0, a.color}, a.rule);
            require(a.rule, rule.position);
        }
    }

    std::size_t drawn(const std::vector<EisenRule>& rules) {
        std::vector<double> weights;
        for (const EisenRule& rule : rules) weights.push_back(rule.weight);
        double left = static_cast<double>(random_()) / 18446744073709551616.0;  // of 2^64
        left *= std::accumulate(weights.begin(), weights.end(), 0.0);
        for (std::size_t i = 0; i < weights.size(); ++i) {
            left -= weights[i];
            if (left < 0) return i;
        }
        return weights.size() - 1;
    }

    void require(const std::string& rule, const Position& place) const {
        if (!script_.rules.contains(rule))
            throw EisenUnknown{place,
                               fmt::format("'{}' is no rule of the script, and no shape that "
                                           "is taken (box and sphere are)",
                                           printable(rule))};
    }

    /// All steps of the loops: the first loop's number of steps first.
    void act(std::size_t number, const std::vector<EisenAction>& actions, const Application& a) {
        for (const EisenAction& action : actions) {
            const bool rule = script_.rules.contains(action.target);
            const EisenShape shape = rule ? EisenShape::none : shape_of(action.target);
            if (!rule && is_grid(action.target)) {
                graph_.grids = true;
                continue;
            }
            if (shape == EisenShape::none) require(action.target, action.position);
            if (shape != EisenShape::none && a.generation + 1 >= script_.max_depth) continue;
            loop(action, 0, Affine{}, a.color, [&](const Affine& map, const EisenColor& color) {
                if (shape != EisenShape::none)
                    return add(number, {map, shape, 0, color}, action.target);
                const std::size_t next =
                    node_of({action.target, a.generation + 1, a.counters, color});
                add(number, {map, EisenShape::none, next, {}}, action.target);
            });
        }
    }

    template <class Place>
    void loop(const EisenAction& action, std::size_t depth, const Affine& map,
              const EisenColor& color, const Place& place) {
        if (depth == action.loops.size()) return place(map, color);
        Affine here = map;
        EisenColor tint = color;
        for (long i = 0; i < action.loops[depth].count; ++i) {
            here = then(action.loops[depth].step.map, here);
            if (colors_ == EisenColors::kept) tint = stepped(tint, action.loops[depth].step);
            loop(action, depth + 1, here, tint, place);
        }
    }

    /// The same node for the same application, unless lots are drawn somewhere inside it.
    std::size_t node_of(Application next) {
        const bool draws = script_.rules.at(next.rule).size() > 1 || any_draws();
        if (!draws) {
            const auto [found, added] = numbers_.emplace(key_of(next), graph_.nodes.size());
            if (!added) return found->second;
        }
        graph_.drawn = graph_.drawn || draws;
        graph_.nodes.emplace_back();
        waiting_.push_back(std::move(next));
        return graph_.nodes.size() - 1;
    }
    [[nodiscard]] bool any_draws() const {
        return std::ranges::any_of(script_.rules,
                                   [](const auto& named) { return named.second.size() > 1; });
    }

    void add(std::size_t number, const EisenEdge& edge, const std::string& rule) {
        if (++edges_ > most_edges_) throw EisenTooMany{rule};
        graph_.nodes[number].edges.push_back(edge);
    }

    /// Without what leads to no shape; nodes only lead to later ones.
    void prune() {
        for (std::size_t i = graph_.nodes.size(); i-- > 0;)
            std::erase_if(graph_.nodes[i].edges, [&](const EisenEdge& edge) {
                return edge.shape == EisenShape::none && graph_.nodes[edge.node].edges.empty();
            });
    }
    void count() {
        std::vector<double> shapes(graph_.nodes.size(), 0);
        for (std::size_t i = graph_.nodes.size(); i-- > 0;)
            for (const EisenEdge& edge : graph_.nodes[i].edges)
                shapes[i] += edge.shape == EisenShape::none ? shapes[edge.node] : 1;
        graph_.shapes = shapes[0];
    }

    const EisenScript& script_;
    EisenColors colors_;
    std::mt19937_64 random_;
    std::size_t most_edges_;
    std::size_t edges_ = 0;
    EisenGraph graph_;
    std::vector<Application> waiting_;  // per node: what it is made from
    std::map<Key, std::size_t> numbers_;
};

}  // namespace

EisenGraph eisen_graph(const EisenScript& script, EisenColors colors, std::uint64_t seed,
                       std::size_t most_edges) {
    return GraphBuilder(script, colors, seed, most_edges).build();
}

}  // namespace pxm::host
