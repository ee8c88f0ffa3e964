// The cells of a level, by the words of so many maps, and which two of them have a common point.
#pragma once

#include <cstddef>
#include <vector>

#include "host/fractal/neighbours/neighbour_graph.hpp"
#include "host/fractal/system/rifs.hpp"

namespace pxm::host {

using CellWord = std::vector<int>;

/// Two words, each at least as long as the level, whose cells have a common point.
struct TouchingWords {
    CellWord first;
    CellWord second;
    int type = 0;  // of the graph
};

class LevelCells {
  public:
    /// The whole, which is level 0. Precondition: the graph is finite.
    LevelCells(const NeighbourGraph& graph, const Rifs& rifs, std::size_t most)
        : graph_(graph), rifs_(rifs), most_(most) {}

    /// To the next level; false if it has more than `most` cells, or ten times as many pairs.
    [[nodiscard]] bool next();

    [[nodiscard]] std::size_t level() const { return level_; }
    [[nodiscard]] const std::vector<CellWord>& cells() const { return cells_; }
    [[nodiscard]] const std::vector<TouchingWords>& pairs() const { return pairs_; }
    /// The follow set that a word leads to.
    [[nodiscard]] std::size_t set_of(const CellWord& word) const;

  private:
    [[nodiscard]] bool divide(std::vector<TouchingWords> waiting);

    const NeighbourGraph& graph_;
    const Rifs& rifs_;
    std::size_t most_;
    std::size_t level_ = 0;
    std::vector<CellWord> cells_{CellWord{}};
    std::vector<TouchingWords> pairs_;
};

}  // namespace pxm::host
