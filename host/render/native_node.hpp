// The native node: the same programs without the machine's limits, faults and counts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "pxm/real.hpp"
#include "pxm/tally.hpp"

namespace pxm::host {

/// Reads the scene block and the textures in place; a heap of its own. One per thread.
template <class Real_>
class NativeNode {
  public:
    using Real = Real_;
    static constexpr bool watched = false;

    /// `entry_bytes` is the size of the records that will be asked for.
    NativeNode(std::span<const std::uint32_t> block, std::span<const std::uint32_t> textures,
               long heap_capacity, std::size_t entry_bytes)
        : block_(block.data()),
          textures_(textures.data()),
          heap_capacity_(static_cast<int>(heap_capacity)),
          order_(static_cast<std::size_t>(heap_capacity)),
          records_(static_cast<std::size_t>(heap_capacity) * entry_bytes) {}

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

  private:
    const std::uint32_t* block_;
    const std::uint32_t* textures_;
    int heap_capacity_;
    std::vector<std::uint32_t> order_;
    std::vector<std::byte> records_;
};

}  // namespace pxm::host
