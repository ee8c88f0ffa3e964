// One pixel node: a DSP32 with 36 kB of fast memory, its share of the front and back frame buffers,
// its z-buffer and texture memory (docs/machine.md). It shares nothing with the others during a
// frame.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "pxm/fault.hpp"
#include "pxm/memory.hpp"
#include "pxm/model.hpp"
#include "pxm/real.hpp"
#include "pxm/tally.hpp"

namespace pxm {

/// Place of a node in the array: it owns the pixels with x mod columns = column, y mod rows = row.
struct NodeId {
    int column = 0;  // 0 to columns - 1
    int row = 0;     // 0 to rows - 1
    bool operator==(const NodeId&) const = default;
};

/// Fast memory that the order of a heap of so many entries takes: a slot number of four bytes each.
[[nodiscard]] constexpr std::int64_t heap_order_bytes(std::int64_t capacity) noexcept {
    return capacity * 4;
}

/// A pixel node that computes with Real: dsp32::Float, float or double.
template <class Real_>
class Node {
  public:
    using Real = Real_;                     // what it computes with
    static constexpr bool watched = false;  // no listener to the search (host::WatchedNode has one)

    Node(NodeId id, int index) : id_(id), index_(index) {}  // with memories that are empty

    [[nodiscard]] NodeId id() const noexcept { return id_; }  // its place
    /// row * columns + column.
    [[nodiscard]] int index() const noexcept { return index_; }

    // --- the shape database in the back frame buffer ---------------------------------------------
    /// The word at a word address, which is counted; beyond the end 0, and the node halts.
    [[nodiscard]] std::uint32_t shape_word(std::uint32_t address) noexcept {
        tally_.add(
            address == next_shape_ ? Operation::shape_sequential : Operation::shape_scattered, 1);
        next_shape_ = address + 1;
        const auto words = back_buffer_.words();
        if (address >= words.size()) {
            halt(back_buffer_, (std::int64_t{address} + 1) * 4);
            return 0;
        }
        return words[address];
    }
    /// The number at a word address, which is counted as its words are.
    [[nodiscard]] Real shape_real(std::uint32_t address) noexcept {
        std::array<std::uint32_t, real_words<Real>> words;
        for (std::uint32_t i = 0; i < real_words<Real>; ++i) words[i] = shape_word(address + i);
        return decode<Real>(words);
    }

    // --- texture memory --------------------------------------------------------------------------
    /// The word at a word address, which is counted; beyond the end 0, and the node halts.
    [[nodiscard]] std::uint32_t texture_word(std::uint32_t address) noexcept {
        tally_.add(
            address == next_texture_ ? Operation::texture_sequential : Operation::texture_scattered,
            1);
        next_texture_ = address + 1;
        const auto words = texture_.words();
        if (address >= words.size()) {
            halt(texture_, (std::int64_t{address} + 1) * 4);
            return 0;
        }
        return words[address];
    }

    // --- fast memory: the program, the heap's order, and the stack at the end --------------------
    /// Takes the place of a program with its constants, and of its stack; a Fault if there is not
    /// as much. Preconditions: whole words, and no heap is reserved yet.
    [[nodiscard]] std::optional<Fault> load_program(std::int64_t program_bytes,
                                                    std::int64_t stack_bytes) {
        program_bytes_ = program_bytes;
        stack_bytes_ = stack_bytes;
        return reserve_fast_memory(0);
    }

    // --- the heap: its entries in z-buffer memory, their order in fast memory --------------------
    /// Entries, 0 before reserve_heap().
    [[nodiscard]] int heap_capacity() const noexcept { return heap_capacity_; }
    /// The slots in the heap's order.
    [[nodiscard]] std::uint32_t* heap_order() noexcept {
        return fast_memory_.records<std::uint32_t>(program_bytes_);
    }
    /// The entries by slot; Precondition: records of the size that was reserved.
    template <class Record>
    [[nodiscard]] Record* heap_records() noexcept {
        return zbuffer_.records<Record>(0);
    }
    /// Bytes of z-buffer memory that a heap of so many entries takes.
    [[nodiscard]] static constexpr std::int64_t heap_bytes(std::int64_t capacity,
                                                           std::int64_t entry_bytes) noexcept {
        return capacity * entry_bytes;
    }
    /// Sets the heap up; a Fault if the z-buffer part or the fast memory is too small for it.
    [[nodiscard]] std::optional<Fault> reserve_heap(int capacity, std::int64_t entry_bytes) {
        if (auto full = reserve_fast_memory(heap_order_bytes(capacity))) return full;
        const std::int64_t bytes = heap_bytes(capacity, entry_bytes);
        if (!zbuffer_.reserve(bytes)) return fault(zbuffer_, bytes);
        heap_capacity_ = capacity;
        return std::nullopt;
    }

    // --- banks -----------------------------------------------------------------------------------
    /// Program, heap's order, stack.
    [[nodiscard]] Bank& fast_memory() noexcept { return fast_memory_; }
    [[nodiscard]] Bank& front_buffer() noexcept { return front_buffer_; }  // the picture
    [[nodiscard]] Bank& back_buffer() noexcept { return back_buffer_; }    // the shape database
    [[nodiscard]] Bank& zbuffer() noexcept { return zbuffer_; }            // entries of the heap
    [[nodiscard]] Bank& texture() noexcept { return texture_; }            // textures

    /// Stores a 32-bit pixel of the front frame buffer; `pixel` counts the node's own pixels.
    void write_pixel(std::uint32_t pixel, std::uint32_t rgba) noexcept {
        tally_.add(Operation::pixel_write, 1);
        tally_.add(Operation::pixel_sequential, 1);
        const auto words = front_buffer_.words();
        if (pixel >= words.size()) {
            halt(front_buffer_, (std::int64_t{pixel} + 1) * 4);
            return;
        }
        words[pixel] = rgba;
    }

    // --- counts and faults -----------------------------------------------------------------------
    /// Counts operations of one kind.
    void tally(Operation operation, std::uint64_t times) noexcept { tally_.add(operation, times); }
    [[nodiscard]] const Tally& tally() const noexcept { return tally_; }  // what was counted
    /// The access that halted this node, if one did.
    [[nodiscard]] const std::optional<Fault>& halted() const noexcept { return halted_; }

  private:
    [[nodiscard]] std::optional<Fault> reserve_fast_memory(std::int64_t order_bytes) {
        const std::int64_t bytes = program_bytes_ + order_bytes + stack_bytes_;
        if (!fast_memory_.reserve(bytes)) return fault(fast_memory_, bytes);
        return std::nullopt;
    }
    [[nodiscard]] Fault fault(const Bank& bank, std::int64_t wanted_bytes) const noexcept {
        return {index_, bank.name(), wanted_bytes, bank.limit_bytes()};
    }
    void halt(const Bank& bank, std::int64_t wanted_bytes) noexcept {
        if (!halted_) halted_ = fault(bank, wanted_bytes);
    }

    NodeId id_;
    int index_;
    Bank fast_memory_{"fast memory", fast_memory_bytes};
    Bank front_buffer_{"front buffer", bank_bytes};
    Bank back_buffer_{"back buffer", bank_bytes};
    Bank zbuffer_{"z-buffer", zbuffer_part_bytes};
    Bank texture_{"texture", texture_part_bytes};
    std::int64_t program_bytes_ = 0;
    std::int64_t stack_bytes_ = 0;
    int heap_capacity_ = 0;
    std::uint32_t next_shape_ = 0xFFFF'FFFF;
    std::uint32_t next_texture_ = 0xFFFF'FFFF;
    Tally tally_;
    std::optional<Fault> halted_;
};

}  // namespace pxm
