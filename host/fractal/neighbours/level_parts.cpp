#include "host/fractal/neighbours/level_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "host/fractal/neighbours/groups.hpp"
#include "host/fractal/neighbours/level_cells.hpp"

namespace pxm::host {

namespace {

constexpr std::size_t most_level = 20;
constexpr std::size_t most_sets = 60;    // follow sets whose parts are counted
constexpr std::size_t most_of_part = 8;  // cells, if its shape is compared

/// A part up to a similarity: the follow set of its first cell, and how cells lie against each
/// other, from the first on. Two parts with the same are copies of each other.
using Shape = std::vector<std::array<int, 3>>;

struct Part {
    std::vector<CellWord> cells;
    std::vector<TouchingWords> pairs;
    bool comparable = true;  // its pairs are pairs of its cells, not of longer words
};

std::vector<Part> parts_of(const LevelCells& level) {
    std::map<CellWord, std::size_t> number;
    for (const CellWord& cell : level.cells()) number.emplace(cell, number.size());
    const auto cell_of = [&](CellWord word) {
        word.resize(level.level());
        return number.at(word);
    };
    Groups groups(level.cells().size());
    for (const TouchingWords& pair : level.pairs())
        groups.join(cell_of(pair.first), cell_of(pair.second));
    std::map<std::size_t, std::size_t> place;
    std::vector<Part> parts;
    const auto part_of = [&](std::size_t cell) -> Part& {
        const auto [at, added] = place.emplace(groups.leader(cell), parts.size());
        if (added) parts.emplace_back();
        return parts[at->second];
    };
    for (const CellWord& cell : level.cells()) part_of(number.at(cell)).cells.push_back(cell);
    for (const TouchingWords& pair : level.pairs()) {
        Part& part = part_of(cell_of(pair.first));
        part.comparable = part.comparable && pair.first.size() == level.level() &&
                          pair.second.size() == level.level();
        if (part.cells.size() <= most_of_part) part.pairs.push_back(pair);
    }
    return parts;
}

/// Cells get their numbers in the order in which types lead to them from the first one.
Shape shape_from(const LevelCells& level, const Part& part, const CellWord& first) {
    std::map<CellWord, int> number{{first, 0}};
    std::vector<CellWord> order{first};
    for (std::size_t i = 0; i < order.size(); ++i) {
        std::vector<std::pair<std::array<int, 2>, CellWord>> others;
        for (const TouchingWords& pair : part.pairs) {
            if (pair.first == order[i]) others.push_back({{pair.type, 0}, pair.second});
            if (pair.second == order[i]) others.push_back({{pair.type, 1}, pair.first});
        }
        std::ranges::sort(others);
        for (const auto& [type, cell] : others)
            if (number.emplace(cell, static_cast<int>(number.size())).second) order.push_back(cell);
    }
    Shape shape{{static_cast<int>(level.set_of(first)), static_cast<int>(order.size()), 0}};
    for (const TouchingWords& pair : part.pairs)
        shape.push_back({number.at(pair.first), number.at(pair.second), pair.type});
    std::ranges::sort(shape.begin() + 1, shape.end());
    return shape;
}

std::optional<Shape> shape_of(const LevelCells& level, const Part& part) {
    if (!part.comparable || part.cells.size() > most_of_part) return std::nullopt;
    std::optional<Shape> least;
    for (const CellWord& cell : part.cells) {
        Shape shape = shape_from(level, part, cell);
        if (!least || shape < *least) least = std::move(shape);
    }
    return least;
}

/// Parts of earlier levels, whose shapes are known.
class KnownParts {
  public:
    /// Whether a part of this later level is a copy of one that it is made from and is not all of.
    [[nodiscard]] bool have_copy(const LevelCells& level, const std::vector<Part>& parts) const {
        std::vector<std::size_t> within(known_.size(), 0);
        std::vector<char> copied(known_.size(), 0);
        for (const Part& part : parts) {
            const auto shape = shape_of(level, part);
            for (std::size_t k = 0; k < known_.size(); ++k) {
                if (!known_[k].hold(part.cells[0])) continue;
                ++within[k];
                if (shape && known_[k].shape == *shape) copied[k] = 1;
            }
        }
        for (std::size_t k = 0; k < known_.size(); ++k)
            if (copied[k] && within[k] > 1) return true;
        return false;
    }

    void add(const LevelCells& level, const std::vector<Part>& parts) {
        for (const Part& part : parts) {
            if (known_.size() == most_known) return;
            if (auto shape = shape_of(level, part)) known_.push_back({*shape, part.cells});
        }
    }

  private:
    static constexpr std::size_t most_known = 200;
    struct Known {
        Shape shape;
        std::vector<CellWord> cells;
        [[nodiscard]] bool hold(const CellWord& word) const {
            return std::ranges::any_of(cells, [&](const CellWord& cell) {
                return std::equal(cell.begin(), cell.end(), word.begin());
            });
        }
    };
    std::vector<Known> known_;
};

/// How many parts there are at the levels from 0 on.
std::vector<std::size_t> counts_of(const NeighbourGraph& graph, const Rifs& rifs,
                                   std::size_t most) {
    std::vector<std::size_t> counts{1};
    LevelCells level(graph, rifs, most);
    while (level.level() < most_level && level.next()) counts.push_back(parts_of(level).size());
    return counts;
}

/// The first level whose numbers of parts, in every follow set, are those of the next one: they
/// stay what they are, for a cell's parts touch those of another cell where the level before had
/// them touch. Nothing if no level was found to be one.
std::optional<std::size_t> level_that_stays(const NeighbourGraph& graph, const Rifs& rifs,
                                            std::size_t most) {
    if (rifs.follow_sets.size() > most_sets) return std::nullopt;
    std::vector<char> stays(most_level, 1);
    for (std::size_t s = 0; s < rifs.follow_sets.size(); ++s) {
        Rifs part = rifs;
        part.start = static_cast<int>(s);
        const auto counts = counts_of(graph, part, most / rifs.follow_sets.size());
        for (std::size_t k = 0; k < stays.size(); ++k)
            if (k + 1 >= counts.size() || counts[k] != counts[k + 1]) stays[k] = 0;
    }
    const auto first = std::ranges::find(stays, char{1});
    if (first == stays.end()) return std::nullopt;
    return static_cast<std::size_t>(first - stays.begin());
}

/// Whether the maps of an IFS fall into groups so that two words whose cells touch have, letter by
/// letter, maps of one group: there are as many parts, or more, as words of groups.
bool touch_by_groups(const NeighbourGraph& graph, const Rifs& rifs) {
    if (rifs.follow_sets.size() != 1) return false;
    Groups groups(rifs.maps.size());
    const auto join = [&](const NeighbourEdge& e) {
        if (e.first < 0 || e.second < 0) return false;  // letters would not stand side by side
        groups.join(static_cast<std::size_t>(e.first), static_cast<std::size_t>(e.second));
        return true;
    };
    for (const NeighbourType& type : graph.types)
        if (type.touches && !std::ranges::all_of(type.edges, join)) return false;
    return std::ranges::all_of(graph.own[0], join) && groups.count() > 1;
}

}  // namespace

LevelParts level_parts(const NeighbourGraph& graph, const Rifs& rifs, std::size_t most) {
    LevelParts result;
    const bool by_groups = touch_by_groups(graph, rifs);
    KnownParts known;
    bool copy = false;
    LevelCells level(graph, rifs, most);
    while (level.level() < most_level && level.next()) {
        const std::vector<Part> parts = parts_of(level);
        result.counts.push_back(parts.size());
        if (by_groups || copy) continue;
        copy = known.have_copy(level, parts);
        known.add(level, parts);
    }
    if (by_groups) {
        result.infinite = true;
        result.why = "cells touch only if the maps of their words are, one by one, of one group";
    } else if (copy) {
        result.infinite = true;
        result.why = "a part is a copy of a larger one that it is in, apart from the rest of it";
    } else if (const auto stays = level_that_stays(graph, rifs, most)) {
        result.infinite = false;
        result.number = *stays == 0 ? 1 : result.counts[*stays - 1];
        result.why = fmt::format("levels {} and {} fall into as many parts, and so do all further",
                                 *stays, *stays + 1);
    } else {
        result.why = "the numbers of parts grow as far as they were counted";
    }
    return result;
}

}  // namespace pxm::host
