#include "host/fractal/neighbours/exact_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "host/fractal/bounds/affine_hull.hpp"
#include "host/fractal/exact/exact_system.hpp"
#include "host/fractal/neighbours/distinct_words.hpp"
#include "host/fractal/neighbours/graph_growth.hpp"
#include "host/fractal/neighbours/level_parts.hpp"
#include "host/fractal/neighbours/level_system.hpp"
#include "host/fractal/neighbours/neighbour_graph.hpp"
#include "host/fractal/neighbours/tile_volume.hpp"
#include "host/fractal/neighbours/triple_graph.hpp"
#include "host/fractal/system/graph_facts.hpp"

namespace pxm::host {

namespace {

constexpr std::size_t most_states = 20'000;   // of words without duplicates
constexpr std::size_t most_triples = 60'000;  // each six times
constexpr std::size_t most_cells = 3'000;     // of a level whose parts are counted

constexpr const char* flat_pieces = "some pieces lie in a smaller line or plane than the maps keep";

/// Whether each E_s has points that span the whole subspace. Turns around a smaller one would be
/// different maps, and the same pieces.
bool pieces_fill(const exact::ExactSystem& system, const Rifs& rifs) {
    return std::ranges::all_of(affine_hulls(rifs), [&](const AffineHull& hull) {
        return hull.dimension >= system.field.dimensions;
    });
}

class Findings {
  public:
    Findings(const exact::ExactSystem& system, const Rifs& rifs, const std::vector<Bounds>& bounds,
             const NeighbourLimits& limits)
        : system_(system),
          rifs_(rifs),
          bounds_(bounds),
          limits_(limits),
          whole_(rifs.follow_sets.size() == 1),
          strong_(graph_facts(rifs).strongly_connected),
          full_(whole_ || pieces_fill(system, rifs)),
          graph_(neighbour_graph(system, rifs, bounds, limits)) {}

    ExactFindings run() {
        describe_numbers();
        if (system_.field.dimensions == 0) {
            point();
            return std::move(found_);
        }
        add_graph();
        add_overlaps();
        add_open_set();
        add_connected();
        add_hausdorff();
        add_interior();
        add_boundary();
        add_triples();
        return std::move(found_);
    }

  private:
    void describe_numbers() {
        found_.degree = system_.field.degree;
        found_.dimensions = system_.field.dimensions;
        found_.numbers =
            found_.degree == 1
                ? "rational, as written"
                : fmt::format("of a number field of degree {}, as written", found_.degree);
    }

    void point() {
        const std::string why = "the attractor is one point";
        found_.finite = {std::nullopt, why};
        found_.overlaps = {std::nullopt, why};
        found_.open_set = {std::nullopt, why};
        found_.connected = {true, why};
        found_.totally_disconnected = {true, why};
        found_.hausdorff = {0.0, why};
        found_.boundary = {std::nullopt, why};
        found_.interior = {std::nullopt, why};
        found_.volume = {std::nullopt, why};
        found_.triples = {std::nullopt, why};
        found_.triple_dimension = {std::nullopt, why};
    }

    [[nodiscard]] bool finite() const { return found_.finite.value.value_or(false); }

    void add_graph() {
        found_.finite = {graph_.finite, graph_.why};
        if (!finite()) return;
        for (const NeighbourType& type : graph_.types) {
            if (!type.touches) continue;
            ++found_.types;
            if (!type.identity) ++found_.touching;
        }
        found_.finite.why = fmt::format("closed under descent: {} types that touch", found_.types);
        add_types();
        std::set<std::array<int, 2>> pairs;
        for (const NeighbourEdge& e : graph_.own[static_cast<std::size_t>(rifs_.start)])
            pairs.insert({std::min(e.first, e.second), std::max(e.first, e.second)});
        found_.touching_maps.assign(pairs.begin(), pairs.end());
    }

    void add_types() {
        std::vector<int> number(graph_.types.size(), -1);
        int next = 0;
        for (std::size_t t = 0; t < number.size(); ++t)
            if (graph_.types[t].touches) number[t] = next++;
        const auto entries = static_cast<std::size_t>(found_.dimensions * (found_.dimensions + 1));
        for (const NeighbourType& type : graph_.types) {
            if (!type.touches) continue;
            TouchingType& kept = found_.graph.emplace_back();
            kept.first = type.first;
            kept.second = type.second;
            kept.identity = type.identity;
            const auto rounded = type.map.rounded(system_.field);
            kept.entries.assign(rounded.entry, rounded.entry + entries);
            for (const NeighbourEdge& e : type.edges)
                kept.edges.push_back({e.first, e.second, number[static_cast<std::size_t>(e.to)]});
        }
        for (const auto& edges : graph_.own) {
            auto& own = found_.own.emplace_back();
            for (const NeighbourEdge& e : edges)
                own.push_back({e.first, e.second, number[static_cast<std::size_t>(e.to)]});
        }
        found_.axes = system_.axes;
    }

    void add_overlaps() {
        const auto same = std::ranges::find_if(graph_.types, &NeighbourType::identity);
        if (same != graph_.types.end()) {
            const WordPair words =
                words_of(graph_, static_cast<std::size_t>(same - graph_.types.begin()));
            found_.overlapping_words = {words.first, words.second};
            found_.overlaps = {true, "two words are the same map, in exact numbers"};
        } else if (finite()) {
            found_.overlaps = {false, "no neighbour map is the identity, in exact numbers"};
        } else {
            found_.overlaps = {std::nullopt, unfinished()};
        }
    }

    [[nodiscard]] std::string unfinished() const { return "the neighbours are " + missing(); }
    [[nodiscard]] std::string missing() const {
        return graph_.finite ? graph_.why : "not searched: " + graph_.why;
    }

    [[nodiscard]] bool similar() const { return !system_.squared_ratio.empty(); }

    void add_open_set() {
        if (found_.overlaps.value.value_or(false)) {
            if (whole_ || strong_) {
                found_.open_set = {false, "two words are the same map, in exact numbers [BG92]"};
            } else {
                found_.open_set = {std::nullopt,
                                   "two words are the same map, but the graph is not strongly "
                                   "connected"};
            }
        } else if (!finite()) {
            found_.open_set = {std::nullopt, unfinished()};
        } else if (!similar()) {
            found_.open_set = {std::nullopt, "not every map is a similitude"};
        } else if (!full_) {
            found_.open_set = {std::nullopt, flat_pieces};
        } else {
            found_.open_set = {true,
                               fmt::format("{} neighbours, none of them the identity, in exact "
                                           "numbers [BG92] [DE05]",
                                           found_.touching)};
        }
    }

    /// Whether the images of a follow set's maps hang together by common points.
    [[nodiscard]] bool hangs_together(std::size_t set) const {
        const std::vector<int>& maps = rifs_.follow_sets[set].maps;
        std::vector<int> leader(rifs_.maps.size());
        std::iota(leader.begin(), leader.end(), 0);
        const auto find = [&](int m) {
            while (leader[static_cast<std::size_t>(m)] != m)
                m = leader[static_cast<std::size_t>(m)];
            return m;
        };
        for (const NeighbourEdge& e : graph_.own[set])
            leader[static_cast<std::size_t>(find(e.first))] = find(e.second);
        return std::ranges::all_of(maps, [&](int m) { return find(m) == find(maps[0]); });
    }

    void add_connected() {
        if (!finite()) {
            found_.connected = {std::nullopt, unfinished()};
            found_.totally_disconnected = {std::nullopt, unfinished()};
            return;
        }
        bool all = true, none = true;
        for (std::size_t s = 0; s < graph_.own.size(); ++s) {
            all = all && hangs_together(s);
            none = none && graph_.own[s].empty();
        }
        if (all) {
            found_.connected = {true, "the maps' images hang together by common points [Hata85]"};
        } else if (!hangs_together(static_cast<std::size_t>(rifs_.start))) {
            found_.connected = {false, "the maps' images fall into groups without a common point"};
        } else {
            found_.connected = {std::nullopt, "a part of the graph falls apart inside of pieces"};
        }
        if (!all) found_.parts_of_levels = level_parts(graph_, rifs_, most_cells);
        if (none) {
            found_.totally_disconnected = {true, "no two images have a common point"};
        } else if (all && found_.dimensions > 0) {
            found_.totally_disconnected = {false, "it is connected and no point"};
        } else if (has_connected_part(graph_, rifs_)) {
            found_.totally_disconnected = {
                false, "some maps' own attractor hangs together by common points [Hata85]"};
        } else {
            found_.totally_disconnected = {std::nullopt, "some images have common points"};
        }
    }

    [[nodiscard]] double approximate(const exact::Polynomial& p) const {
        exact::Algebraic a = system_.numbers.lifted(exact::whole(0));
        a.value = p;
        return system_.numbers.approximate(a);
    }

    [[nodiscard]] double log_ratio(int map) const {
        if (map < 0) return 0;
        return std::log(approximate(system_.squared_ratio[static_cast<std::size_t>(map)])) / 2;
    }

    void add_hausdorff() {
        if (!similar()) {
            found_.hausdorff = {std::nullopt, "not every map is a similitude"};
        } else if (!full_) {
            found_.hausdorff = {std::nullopt, flat_pieces};
        } else if (found_.open_set.value.value_or(false)) {
            GrowthGraph graph(rifs_.follow_sets.size());
            for (std::size_t s = 0; s < graph.size(); ++s)
                for (const int m : rifs_.follow_sets[s].maps)
                    graph[s].push_back(
                        {rifs_.follow_of[static_cast<std::size_t>(m)], log_ratio(m)});
            set_dimension(graph,
                          "the similarity dimension: similitudes with the open-set condition, in "
                          "exact numbers (Theorem 5.4)");
        } else if (!finite()) {
            found_.hausdorff = {std::nullopt, unfinished()};
        } else if (!found_.overlaps.value.value_or(false)) {
            found_.hausdorff = {std::nullopt, found_.open_set.why};
        } else if (!system_.equal_ratios) {
            try {
                level_dimension();
            } catch (const exact::NotExact& reason) {
                found_.hausdorff = {std::nullopt, reason.why};
            }
        } else {
            reduced_dimension();
        }
    }

    /// Where cells coincide and ratios differ.
    void level_dimension() {
        const auto levels =
            whole_ ? level_system(system_, rifs_, bounds_[0]) : std::optional<LevelSystem>{};
        if (!levels) {
            found_.hausdorff = {std::nullopt,
                                "cells coincide, and the maps' ratios are no small "
                                "powers of one number"};
            return;
        }
        const NeighbourGraph graph =
            neighbour_graph(levels->system, levels->rifs, levels->bounds, limits_);
        if (!graph.finite.value_or(false)) {
            found_.hausdorff = {std::nullopt, "of the system with maps of one ratio: " + graph.why};
            return;
        }
        const auto words = distinct_words(graph, levels->rifs, most_states);
        if (!words) {
            too_many_states();
            return;
        }
        GrowthGraph growth;
        for (const auto& steps : words->states) {
            auto& row = growth.emplace_back();
            for (const auto& step : steps) row.push_back({step.to, levels->log_ratio});
        }
        set_dimension(growth, fmt::format("finite type: with maps of one ratio, the words that "
                                          "equal no earlier one, a graph of {} states [NW01] "
                                          "[Zerner96]",
                                          words->states.size()));
    }

    void too_many_states() {
        found_.hausdorff = {std::nullopt, fmt::format("the system without duplicates has more "
                                                      "than {} states",
                                                      most_states)};
    }

    void reduced_dimension() {
        const auto words = distinct_words(graph_, rifs_, most_states);
        if (!words) {
            too_many_states();
            return;
        }
        GrowthGraph graph;
        for (const auto& steps : words->states) {
            auto& row = graph.emplace_back();
            auto& kept = found_.distinct.emplace_back();
            for (const auto& step : steps) {
                row.push_back({step.to, log_ratio(step.map)});
                kept.push_back({step.map, step.to});
            }
        }
        set_dimension(graph, fmt::format("finite type: the words that equal no earlier one, a "
                                         "graph of {} states [NW01] [Zerner96]",
                                         words->states.size()));
    }

    void set_dimension(const GrowthGraph& graph, const std::string& why) {
        const auto exponent = growth_exponent(graph);
        if (exponent) found_.hausdorff = {exponent->middle(), why};
    }

    /// The sign of (the sum of the volume ratios) - 1. Of one follow set.
    [[nodiscard]] int volume_excess() const {
        exact::Polynomial sum(-1);
        for (const exact::Polynomial& det : system_.volume_ratio)
            sum = sign(det) < 0 ? sum - det : sum + det;
        return sign(sum);
    }

    void empty_inside(const std::string& why) {
        found_.interior = {false, why};
        found_.volume = {0.0, why};
    }

    void add_interior() {
        if (is_interval()) {
            found_.interior = {true, "a connected set in a line is an interval"};
            found_.volume = {std::nullopt, "not computed"};
            if (exact::is_coordinate_plane(system_))
                found_.volume = {interval_length(), "the length of an interval"};
            return;
        }
        if (whole_) {
            const int excess = volume_excess();
            if (excess < 0)
                return empty_inside("the maps' volumes add up to less than the whole's");
            if (excess == 0 && found_.overlaps.value.value_or(false))
                return empty_inside(
                    "the maps' volumes add up to the whole's, and two words are the same map");
        }
        if (found_.open_set.value.value_or(false) && volumes_balance()) {
            found_.interior = {true,
                               "the open-set condition holds and the maps' volumes add up to the "
                               "whole's [Schief94]"};
            add_tile_volume();
            return;
        }
        add_interior_of_graph();
    }

    void add_tile_volume() {
        try {
            auto [volume, between] = tile_volume(system_, rifs_, graph_, bounds_,
                                                 found_.connected.value.value_or(false));
            found_.volume = std::move(volume);
            found_.volume_between = between;
        } catch (const exact::NotExact& reason) {
            found_.volume = {std::nullopt, "not computed: " + reason.why};
        }
    }

    [[nodiscard]] bool is_interval() const {
        return full_ && found_.dimensions == 1 && found_.connected.value.value_or(false);
    }

    /// From the equation that the ends of all pieces have, in double.
    [[nodiscard]] double interval_length() const {
        constexpr int most_rounds = 10'000;
        const int axis = system_.axes[0];
        std::vector<std::array<double, 2>> ends;
        for (const Bounds& b : bounds_) ends.push_back({b.ball.center[axis], b.ball.center[axis]});
        for (int round = 0; round < most_rounds; ++round) {
            auto next = ends;
            for (std::size_t s = 0; s < ends.size(); ++s) {
                next[s] = {INFINITY, -INFINITY};
                for (const int m : rifs_.follow_sets[s].maps) {
                    const auto map = static_cast<std::size_t>(m);
                    for (const double end : ends[static_cast<std::size_t>(rifs_.follow_of[map])]) {
                        glm::dvec3 p = bounds_[s].ball.center;
                        p[axis] = end;
                        const double image = rifs_.maps[map].point(p)[axis];
                        next[s] = {std::min(next[s][0], image), std::max(next[s][1], image)};
                    }
                }
            }
            if (next == ends) break;
            ends = std::move(next);
        }
        const auto start = static_cast<std::size_t>(rifs_.start);
        return ends[start][1] - ends[start][0];
    }

    /// Whether the follow sets can have positive volumes of which each is the sum of its maps'
    /// images: a positive vector v with v_s = sum of |det m| v_t over the maps m of s.
    [[nodiscard]] bool volumes_balance() const {
        constexpr std::size_t most = 60;  // follow sets: elimination takes their third power
        const std::size_t n = rifs_.follow_sets.size();
        if (n > most || !(whole_ || strong_)) return false;
        std::vector<std::vector<exact::Polynomial>> rows(n, std::vector<exact::Polynomial>(n));
        for (std::size_t s = 0; s < n; ++s) {
            rows[s][s] = exact::Polynomial(-1);
            for (const int m : rifs_.follow_sets[s].maps) {
                const auto map = static_cast<std::size_t>(m);
                const exact::Polynomial& det = system_.volume_ratio[map];
                exact::Polynomial& at = rows[s][static_cast<std::size_t>(rifs_.follow_of[map])];
                at = sign(det) < 0 ? at - det : at + det;
            }
        }
        const auto kernel = exact::kernel_vector(system_, rows);
        return kernel && std::ranges::all_of(*kernel, [&](const exact::Polynomial& p) {
                   return sign(p) == sign(kernel->front()) && sign(p) != 0;
               });
    }

    [[nodiscard]] int sign(const exact::Polynomial& p) const {
        exact::Algebraic a = system_.numbers.lifted(exact::whole(0));
        a.value = p;
        return system_.numbers.sign(a);
    }

    void add_interior_of_graph() {
        constexpr double clearly = 1e-9;
        if (found_.hausdorff.value && *found_.hausdorff.value < found_.dimensions - clearly)
            return empty_inside("its dimension is less than the space's");
        const std::string why = found_.hausdorff.value
                                    ? "the dimension alone does not tell"
                                    : "the dimension is not known: " + found_.hausdorff.why;
        found_.interior = {std::nullopt, why};
        found_.volume = {std::nullopt, why};
    }

    void add_boundary() {
        if (found_.interior.value && !*found_.interior.value) {
            found_.boundary = {found_.hausdorff.value,
                               found_.hausdorff.value
                                   ? "without inside, it is its own boundary"
                                   : "it is its own boundary, whose dimension is not known: " +
                                         found_.hausdorff.why};
            return;
        }
        if (!found_.interior.value) {
            found_.boundary = {std::nullopt, found_.interior.why};
            return;
        }
        if (is_interval()) {
            found_.boundary = {0.0, "the two ends of an interval"};
            return;
        }
        GrowthGraph graph(graph_.types.size());
        for (std::size_t t = 0; t < graph.size(); ++t)
            for (const NeighbourEdge& e : graph_.types[t].edges)
                graph[t].push_back({e.to, log_ratio(e.first)});
        const auto exponent = growth_exponent(graph);
        if (!exponent) {
            found_.boundary = {std::nullopt, "it has no neighbours"};
            return;
        }
        found_.boundary = {exponent->middle(),
                           "where cells meet their neighbours, a graph-directed set [DKV00] "
                           "[Falconer95]"};
    }

    void add_triples() {
        if (!finite()) {
            found_.triples = {std::nullopt, unfinished()};
            found_.triple_dimension = {std::nullopt, unfinished()};
            return;
        }
        const TripleGraph triples = triple_graph(graph_, most_triples);
        if (!triples.complete) {
            found_.triples = {std::nullopt, triples.why};
            found_.triple_dimension = {std::nullopt, triples.why};
            return;
        }
        found_.triples = {triples.count(),
                          "three cells that can be divided for ever so that each "
                          "two touch have a common point [BM09]"};
        if (triples.types.empty()) {
            found_.triple_dimension = {std::nullopt, "no three cells meet"};
        } else if (!found_.open_set.value.value_or(false)) {
            found_.triple_dimension = {std::nullopt, found_.open_set.why};
        } else {
            GrowthGraph growth(triples.types.size());
            for (std::size_t k = 0; k < growth.size(); ++k)
                for (const TripleEdge& e : triples.types[k].edges)
                    growth[k].push_back({e.to, log_ratio(e.maps[0])});
            const auto exponent = growth_exponent(growth);
            found_.triple_dimension = {exponent->middle(),
                                       "where three cells meet, a graph-directed set [DKV00] "
                                       "[Falconer95]"};
        }
    }

    const exact::ExactSystem& system_;
    const Rifs& rifs_;
    const std::vector<Bounds>& bounds_;
    NeighbourLimits limits_;
    bool whole_;  // one follow set: an IFS
    bool strong_;
    bool full_;  // no piece lies in a smaller subspace than the maps keep
    NeighbourGraph graph_;
    ExactFindings found_;
};

}  // namespace

ExactFindings find_exactly(exact::WrittenMaps written, const Rifs& rifs,
                           const std::vector<Bounds>& bounds, const NeighbourLimits& limits) {
    try {
        const exact::ExactSystem system = exact::exact_system(std::move(written), rifs);
        return Findings(system, rifs, bounds, limits).run();
    } catch (const exact::NotExact& reason) {
        return nothing_exact(reason.why);
    }
}

}  // namespace pxm::host
