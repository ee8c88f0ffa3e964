// The node that the modules of the node program are measured on (docs/program-memory.md). It has
// the interface of pxm::Node without what the emulator adds: its tallies are empty, a read of the
// shape database is a plain load, a record of the heap a plain address. Nothing of it is ever run.
#pragma once

#include <bit>
#include <cstdint>

#include "pxm/node_like.hpp"

namespace pxm::kernels {

/// A node of which a compiler for small processors can tell how large its program is.
class MeasuredNode {
  public:
    using Real = float;                     // of the node
    static constexpr bool watched = false;  // no listener to the search

    /// By word address, as all three.
    [[nodiscard]] std::uint32_t shape_word(std::uint32_t address) const noexcept {
        return back_buffer_[address];
    }
    /// The same as a number.
    [[nodiscard]] float shape_real(std::uint32_t address) const noexcept {
        return std::bit_cast<float>(back_buffer_[address]);
    }
    /// Of the texture memory.
    [[nodiscard]] std::uint32_t texture_word(std::uint32_t address) const noexcept {
        return texture_[address];
    }
    [[nodiscard]] int heap_capacity() const noexcept { return heap_capacity_; }  // entries
    /// Slots in the heap's order.
    [[nodiscard]] std::uint32_t* heap_order() const noexcept { return heap_order_; }
    /// Entries by slot.
    template <class Record>
    [[nodiscard]] Record* heap_records() const noexcept {
        return static_cast<Record*>(zbuffer_);
    }
    void tally(Operation, std::uint64_t) const noexcept {}  // counts nothing
    /// A pixel of the front buffer.
    void write_pixel(std::uint32_t pixel, std::uint32_t rgba) const noexcept {
        front_buffer_[pixel] = rgba;
    }

  private:
    std::uint32_t* front_buffer_ = nullptr;
    const std::uint32_t* back_buffer_ = nullptr;
    const std::uint32_t* texture_ = nullptr;
    void* zbuffer_ = nullptr;
    std::uint32_t* heap_order_ = nullptr;
    int heap_capacity_ = 0;
};

/// The name the modules instantiate with.
using Node = MeasuredNode;

}  // namespace pxm::kernels
