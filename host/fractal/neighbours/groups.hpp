// Groups of things that hang together: maps or cells, numbered, that are joined where they have a
// common point.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace pxm::host {

class Groups {
  public:
    /// Each alone.
    explicit Groups(std::size_t count) : leader_(count) {
        std::iota(leader_.begin(), leader_.end(), std::size_t{0});
    }

    /// The one that stands for its group.
    std::size_t leader(std::size_t i) {
        while (leader_[i] != i) i = leader_[i] = leader_[leader_[i]];
        return i;
    }
    void join(std::size_t i, std::size_t k) { leader_[leader(i)] = leader(k); }
    [[nodiscard]] std::size_t count() const {
        std::size_t found = 0;
        for (std::size_t i = 0; i < leader_.size(); ++i) found += leader_[i] == i ? 1 : 0;
        return found;
    }
    /// Whether all of these maps are in one group. Precondition: there is one.
    [[nodiscard]] bool hold_together(const std::vector<int>& maps) {
        const std::size_t first = leader(static_cast<std::size_t>(maps[0]));
        return std::ranges::all_of(
            maps, [&](int m) { return leader(static_cast<std::size_t>(m)) == first; });
    }

  private:
    std::vector<std::size_t> leader_;
};

}  // namespace pxm::host
