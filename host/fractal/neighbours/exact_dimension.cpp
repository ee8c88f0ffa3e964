#include "host/fractal/neighbours/exact_dimension.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "host/fractal/neighbours/distinct_words.hpp"
#include "host/fractal/neighbours/graph_growth.hpp"
#include "host/fractal/neighbours/level_system.hpp"

namespace pxm::host {

namespace {

constexpr std::size_t most_states = 20'000;  // of words without duplicates

class DimensionSearch {
  public:
    DimensionSearch(const SearchedSystem& searched, const Decided<bool>& overlaps,
                    const Decided<bool>& open_set)
        : searched_(searched), overlaps_(overlaps), open_set_(open_set) {}

    ExactDimension run() {
        if (!searched_.similar() && open_set_.value.value_or(false)) {
            result_.value = {searched_.exact.field.dimensions,
                             "it has an inside: " + open_set_.why};
        } else if (!searched_.similar()) {
            result_.value = {std::nullopt, "not every map is a similitude"};
        } else if (!searched_.full) {
            result_.value = {std::nullopt, flat_pieces};
        } else if (open_set_.value.value_or(false)) {
            GrowthGraph graph(searched_.rifs.follow_sets.size());
            for (std::size_t s = 0; s < graph.size(); ++s)
                for (const int m : searched_.rifs.follow_sets[s].maps)
                    graph[s].push_back({searched_.rifs.follow_of[static_cast<std::size_t>(m)],
                                        searched_.log_ratio(m)});
            set_dimension(graph,
                          "the similarity dimension: similitudes with the open-set condition, in "
                          "exact numbers (Theorem 5.4)");
        } else if (!searched_.finite()) {
            result_.value = {std::nullopt, searched_.unfinished()};
        } else if (!overlaps_.value.value_or(false)) {
            result_.value = {std::nullopt, open_set_.why};
        } else if (!searched_.exact.equal_ratios) {
            try {
                level_dimension();
            } catch (const exact::NotExact& reason) {
                result_.value = {std::nullopt, reason.why};
            }
        } else {
            reduced_dimension();
        }
        return std::move(result_);
    }

  private:
    /// Where cells coincide and ratios differ.
    void level_dimension() {
        const auto levels = searched_.whole
                                ? level_system(searched_.exact, searched_.rifs, searched_.bounds[0])
                                : std::optional<LevelSystem>{};
        if (!levels) {
            result_.value = {std::nullopt,
                             "cells coincide, and the maps' ratios are no small "
                             "powers of one number"};
            return;
        }
        const NeighbourGraph graph =
            neighbour_graph(levels->system, levels->rifs, levels->bounds, searched_.limits);
        if (!graph.finite.value_or(false)) {
            result_.value = {std::nullopt, "of the system with maps of one ratio: " + graph.why};
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
        result_.value = {std::nullopt, fmt::format("the system without duplicates has more "
                                                   "than {} states",
                                                   most_states)};
    }

    void reduced_dimension() {
        const auto words = distinct_words(searched_.graph, searched_.rifs, most_states);
        if (!words) {
            too_many_states();
            return;
        }
        GrowthGraph graph;
        for (const auto& steps : words->states) {
            auto& row = graph.emplace_back();
            auto& kept = result_.distinct.emplace_back();
            for (const auto& step : steps) {
                row.push_back({step.to, searched_.log_ratio(step.map)});
                kept.push_back({step.map, step.to});
            }
        }
        set_dimension(graph, fmt::format("finite type: the words that equal no earlier one, a "
                                         "graph of {} states [NW01] [Zerner96]",
                                         words->states.size()));
    }

    void set_dimension(const GrowthGraph& graph, const std::string& why) {
        const auto exponent = growth_exponent(graph);
        if (exponent) result_.value = {exponent->middle(), why};
    }

    const SearchedSystem& searched_;
    const Decided<bool>& overlaps_;
    const Decided<bool>& open_set_;
    ExactDimension result_;
};

}  // namespace

ExactDimension exact_dimension(const SearchedSystem& searched, const Decided<bool>& overlaps,
                               const Decided<bool>& open_set) {
    return DimensionSearch(searched, overlaps, open_set).run();
}

}  // namespace pxm::host
