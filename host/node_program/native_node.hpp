// The native node: the same programs without the machine's limits, faults and counts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <vector>

#include "host/node_program/known_cells.hpp"
#include "pxm/real.hpp"
#include "pxm/tally.hpp"

namespace pxm::host {

/// Reads the scene block and the textures in place; a heap of its own. One per thread.
template <class Real_>
class NativeNode {
  public:
    using Real = Real_;
    static constexpr bool watched = false;

    /// `entry_bytes` is the size of the records that will be asked for. Of the cells that a ray has
    /// opened a record is kept (host/node_program/known_cells.hpp) if there is a `known_share` of a
    /// pixel by which cells are told apart.
    NativeNode(std::span<const std::uint32_t> block, std::span<const std::uint32_t> textures,
               long heap_capacity, std::size_t entry_bytes, double known_share = 0)
        : block_(block.data()),
          textures_(textures.data()),
          heap_capacity_(static_cast<int>(heap_capacity)),
          known_share_(known_share),
          order_(static_cast<std::size_t>(heap_capacity)),
          records_(static_cast<std::size_t>(heap_capacity) * entry_bytes) {
        if (known_share > 0) known_.emplace();
    }

    [[nodiscard]] std::uint32_t shape_word(std::uint32_t address) const noexcept {
        return block_[address];
    }
    [[nodiscard]] Real shape_real(std::uint32_t address) const noexcept {
        EncodedReal<Real> words;
        std::memcpy(words.data(), block_ + address, sizeof words);  // one load, not one a word
        return decode<Real>(words);
    }
    [[nodiscard]] std::uint32_t texture_word(std::uint32_t address) const noexcept {
        return textures_[address];
    }
    [[nodiscard]] int heap_capacity() const noexcept { return heap_capacity_; }
    [[nodiscard]] std::uint32_t* heap_order() noexcept { return order_.data(); }
    template <class Record>
    [[nodiscard]] Record* heap_records() noexcept {
        return reinterpret_cast<Record*>(records_.data());
    }
    void tally(Operation, std::uint64_t) const noexcept {}
    [[nodiscard]] bool knows_cells() const noexcept { return known_.has_value(); }
    void forget_known() noexcept {
        if (known_) known_->forget();
    }
    [[nodiscard]] bool knows(const kernels::Search<Real>& search,
                             const kernels::Cell<Real>& cell) noexcept {
        return known_ && knows_cell(*this, *known_, known_share_, search, cell);
    }

  private:
    const std::uint32_t* block_;
    const std::uint32_t* textures_;
    int heap_capacity_;
    double known_share_;
    std::vector<std::uint32_t> order_;
    std::vector<std::byte> records_;
    std::optional<KnownCells> known_;
};

}  // namespace pxm::host
