// The node that the modules of the node program are measured on (docs/program-memory.md). It has
// the interface of pxm::Node without what the emulator adds: its tallies are empty, a read of the
// shape database is a plain load, a record of the heap a plain address. Nothing of it is ever run.
#pragma once

#include <bit>
#include <cstdint>

#include "pxm/node_like.hpp"

namespace pxm::kernels {

class MeasuredNode {
  public:
    using Real = float;
    static constexpr bool watched = false;

    [[nodiscard]] std::uint32_t shape_word(std::uint32_t address) const noexcept {
        return back_buffer_[address];
    }
    [[nodiscard]] float shape_real(std::uint32_t address) const noexcept {
        return std::bit_cast<float>(back_buffer_[address]);
    }
    [[nodiscard]] std::uint32_t texture_word(std::uint32_t address) const noexcept {
        return texture_[address];
    }
    [[nodiscard]] int heap_capacity() const noexcept { return heap_capacity_; }
    [[nodiscard]] std::uint32_t* heap_order() const noexcept { return heap_order_; }
    template <class Record>
    [[nodiscard]] Record* heap_records() const noexcept {
        return static_cast<Record*>(zbuffer_);
    }
    void tally(Operation, std::uint64_t) const noexcept {}
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
