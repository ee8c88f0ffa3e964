#include "host/fractal/neighbours/exact_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "host/fractal/exact/exact_system.hpp"
#include "host/fractal/neighbours/affine_tile.hpp"
#include "host/fractal/neighbours/connected_part.hpp"
#include "host/fractal/neighbours/exact_boundary.hpp"
#include "host/fractal/neighbours/exact_dimension.hpp"
#include "host/fractal/neighbours/exact_inside.hpp"
#include "host/fractal/neighbours/graph_growth.hpp"
#include "host/fractal/neighbours/groups.hpp"
#include "host/fractal/neighbours/level_parts.hpp"
#include "host/fractal/neighbours/neighbour_graph.hpp"
#include "host/fractal/neighbours/searched_system.hpp"
#include "host/fractal/neighbours/triple_graph.hpp"

namespace pxm::host {

namespace {

constexpr std::size_t most_triples = 60'000;  // each six times
constexpr std::size_t most_cells = 3'000;     // of a level whose parts are counted

class Findings {
  public:
    Findings(const exact::ExactSystem& system, const Rifs& rifs, const std::vector<Bounds>& bounds,
             const NeighbourLimits& limits)
        : searched_(system, rifs, bounds, limits) {}

    ExactFindings run() {
        describe_numbers();
        if (searched_.exact.field.dimensions == 0) {
            point();
            return std::move(found_);
        }
        add_graph();
        add_overlaps();
        add_open_set();
        add_connected();
        add_dimension();
        add_inside();
        found_.boundary = exact_boundary(searched_, found_);
        add_triples();
        return std::move(found_);
    }

  private:
    void describe_numbers() {
        found_.degree = searched_.exact.field.degree;
        found_.dimensions = searched_.exact.field.dimensions;
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
        found_.components = {1, why};
        found_.infinite_components = false;
        found_.hausdorff = {0.0, why};
        found_.boundary = {std::nullopt, why};
        found_.interior = {std::nullopt, why};
        found_.volume = {std::nullopt, why};
        found_.triples = {std::nullopt, why};
        found_.triple_dimension = {std::nullopt, why};
    }

    void add_graph() {
        found_.finite = {searched_.graph.finite, searched_.graph.why};
        if (!searched_.finite()) return;
        for (const NeighbourType& type : searched_.graph.types) {
            if (!type.touches) continue;
            ++found_.types;
            if (!type.identity) ++found_.touching;
        }
        found_.finite.why = fmt::format("closed under descent: {} types that touch", found_.types);
        add_types();
        std::set<std::array<int, 2>> pairs;
        for (const NeighbourEdge& e :
             searched_.graph.own[static_cast<std::size_t>(searched_.rifs.start)])
            pairs.insert({std::min(e.first, e.second), std::max(e.first, e.second)});
        found_.touching_maps.assign(pairs.begin(), pairs.end());
    }

    void add_types() {
        std::vector<int> number(searched_.graph.types.size(), -1);
        int next = 0;
        for (std::size_t t = 0; t < number.size(); ++t)
            if (searched_.graph.types[t].touches) number[t] = next++;
        const auto entries = static_cast<std::size_t>(found_.dimensions * (found_.dimensions + 1));
        for (const NeighbourType& type : searched_.graph.types) {
            if (!type.touches) continue;
            TouchingType& kept = found_.graph.emplace_back();
            kept.first = type.first;
            kept.second = type.second;
            kept.identity = type.identity;
            const auto rounded = type.map.rounded(searched_.exact.field);
            kept.entries.assign(rounded.entry, rounded.entry + entries);
            for (const NeighbourEdge& e : type.edges)
                kept.edges.push_back({e.first, e.second, number[static_cast<std::size_t>(e.to)]});
        }
        for (const auto& edges : searched_.graph.own) {
            auto& own = found_.own.emplace_back();
            for (const NeighbourEdge& e : edges)
                own.push_back({e.first, e.second, number[static_cast<std::size_t>(e.to)]});
        }
        found_.axes = searched_.exact.axes;
    }

    void add_overlaps() {
        const auto same = std::ranges::find_if(searched_.graph.types, &NeighbourType::identity);
        if (same != searched_.graph.types.end()) {
            const WordPair words = words_of(
                searched_.graph, static_cast<std::size_t>(same - searched_.graph.types.begin()));
            found_.overlapping_words = {words.first, words.second};
            found_.overlaps = {true, "two words are the same map, in exact numbers"};
        } else if (searched_.finite()) {
            found_.overlaps = {false, "no neighbour map is the identity, in exact numbers"};
        } else {
            found_.overlaps = {std::nullopt, searched_.unfinished()};
        }
    }

    void add_open_set() {
        if (found_.overlaps.value.value_or(false)) {
            if (searched_.whole || searched_.strong) {
                found_.open_set = {false, "two words are the same map, in exact numbers [BG92]"};
            } else {
                found_.open_set = {std::nullopt,
                                   "two words are the same map, but the graph is not strongly "
                                   "connected"};
            }
        } else if (!searched_.finite()) {
            found_.open_set = {std::nullopt, searched_.unfinished()};
        } else if (!searched_.similar() && searched_.whole && has_lattice_digits(searched_.exact)) {
            found_.open_set = {true,
                               "a tile: digits of a lattice, as many as the determinant, and no "
                               "two words are the same map, in exact numbers [LaWa96]"};
        } else if (!searched_.similar()) {
            found_.open_set = {std::nullopt, "not every map is a similitude"};
        } else if (!searched_.full) {
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
        Groups groups(searched_.rifs.maps.size());
        for (const NeighbourEdge& e : searched_.graph.own[set])
            groups.join(static_cast<std::size_t>(e.first), static_cast<std::size_t>(e.second));
        return groups.hold_together(searched_.rifs.follow_sets[set].maps);
    }

    void add_connected() {
        if (!searched_.finite()) {
            found_.connected = {std::nullopt, searched_.unfinished()};
            found_.totally_disconnected = {std::nullopt, searched_.unfinished()};
            found_.components = {std::nullopt, searched_.unfinished()};
            return;
        }
        bool all = true, none = true;
        for (std::size_t s = 0; s < searched_.graph.own.size(); ++s) {
            all = all && hangs_together(s);
            none = none && searched_.graph.own[s].empty();
        }
        if (all) {
            found_.connected = {true, "the maps' images hang together by common points [Hata85]"};
        } else if (!hangs_together(static_cast<std::size_t>(searched_.rifs.start))) {
            found_.connected = {false, "the maps' images fall into groups without a common point"};
        } else {
            found_.connected = {std::nullopt, "a part of the graph falls apart inside of pieces"};
        }
        add_components();
        if (none) {
            found_.totally_disconnected = {true, "no two images have a common point"};
        } else if (found_.connected.value.value_or(false) && found_.dimensions > 0) {
            found_.totally_disconnected = {false, "it is connected and no point"};
        } else if (has_connected_part(searched_.graph, searched_.rifs)) {
            found_.totally_disconnected = {
                false, "some maps' own attractor hangs together by common points [Hata85]"};
        } else {
            found_.totally_disconnected = {std::nullopt, "some images have common points"};
        }
    }

    void add_components() {
        if (found_.connected.value.value_or(false)) {
            found_.components = {1, found_.connected.why};
            found_.infinite_components = false;
            return;
        }
        LevelParts parts = level_parts(searched_.graph, searched_.rifs, most_cells);
        found_.parts_of_levels = std::move(parts.counts);
        found_.components = {parts.number, std::move(parts.why)};
        found_.infinite_components = parts.infinite;
        if (found_.connected.value) return;
        if (parts.number == 1U) {
            found_.connected = {true, "at every level all cells hang together by common points"};
        } else if (!found_.parts_of_levels.empty() && found_.parts_of_levels.back() > 1) {
            found_.connected = {
                false, fmt::format("the cells of level {} fall into {} parts",
                                   found_.parts_of_levels.size(), found_.parts_of_levels.back())};
        }
    }

    void add_dimension() {
        ExactDimension dimension = exact_dimension(searched_, found_.overlaps, found_.open_set);
        found_.hausdorff = std::move(dimension.value);
        found_.distinct = std::move(dimension.distinct);
    }

    void add_inside() {
        ExactInside inside = exact_inside(searched_, found_);
        found_.interior = std::move(inside.inside);
        found_.volume = std::move(inside.volume);
        found_.volume_between = inside.between;
    }

    void add_triples() {
        if (!searched_.finite()) {
            found_.triples = {std::nullopt, searched_.unfinished()};
            found_.triple_dimension = {std::nullopt, searched_.unfinished()};
            return;
        }
        const TripleGraph triples = triple_graph(searched_.graph, most_triples);
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
        } else if (!searched_.similar()) {
            found_.triple_dimension = {std::nullopt, "not every map is a similitude"};
        } else {
            GrowthGraph growth(triples.types.size());
            for (std::size_t k = 0; k < growth.size(); ++k)
                for (const TripleEdge& e : triples.types[k].edges)
                    growth[k].push_back({e.to, searched_.log_ratio(e.maps[0])});
            const auto exponent = growth_exponent(growth);
            found_.triple_dimension = {exponent->middle(),
                                       "where three cells meet, a graph-directed set [DKV00] "
                                       "[Falconer95]"};
        }
    }

    SearchedSystem searched_;
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
