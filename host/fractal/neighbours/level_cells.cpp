#include "host/fractal/neighbours/level_cells.hpp"

#include <utility>

namespace pxm::host {

namespace {

constexpr std::size_t pairs_a_cell = 10;

TouchingWords longer(TouchingWords pair, const NeighbourEdge& e) {
    if (e.first >= 0) pair.first.push_back(e.first);
    if (e.second >= 0) pair.second.push_back(e.second);
    pair.type = e.to;
    return pair;
}

}  // namespace

std::size_t LevelCells::set_of(const CellWord& word) const {
    return static_cast<std::size_t>(
        word.empty() ? rifs_.start : rifs_.follow_of[static_cast<std::size_t>(word.back())]);
}

bool LevelCells::next() {
    std::vector<CellWord> cells;
    std::vector<TouchingWords> waiting = std::move(pairs_);
    pairs_.clear();
    for (const CellWord& cell : cells_) {
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
    ++level_;
    return divide(std::move(waiting));
}

bool LevelCells::divide(std::vector<TouchingWords> waiting) {
    while (!waiting.empty()) {
        if (pairs_.size() + waiting.size() > pairs_a_cell * most_) return false;
        const TouchingWords pair = std::move(waiting.back());
        waiting.pop_back();
        if (pair.first.size() >= level_ && pair.second.size() >= level_) {
            pairs_.push_back(pair);
            continue;
        }
        for (const NeighbourEdge& e : graph_.types[static_cast<std::size_t>(pair.type)].edges)
            waiting.push_back(longer(pair, e));
    }
    return true;
}

}  // namespace pxm::host
