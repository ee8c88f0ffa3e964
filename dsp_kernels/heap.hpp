// The heap of cells (Def. 12.1, Erratum 1: the top is the smallest), bounded: entries in z-buffer
// memory, their order in fast memory. A full heap loses nothing: the largest cell is dropped and
// the smallest cell ever dropped, D, is remembered. What is not before D need not be kept, so every
// cell in the heap is before D, and when the heap runs empty the search goes on from D
// (dsp_kernels/next_after.hpp). Node code: no allocation, no exceptions.
#pragma once

#include <cstdint>

#include "dsp_kernels/cell.hpp"

namespace pxm::kernels {

/// A binary heap of slot numbers over fixed slots: cells are written once and moved by number.
template <NodeLike Node>
class Heap {
  public:
    using Entry = Cell<typename Node::Real>;  // what it holds

    /// Lays the heap over the node's memories.
    explicit Heap(Node& node) noexcept
        : node_(node),
          order_(node.heap_order()),
          slots_(node.template heap_records<Entry>()),
          capacity_(static_cast<std::uint32_t>(node.heap_capacity())) {
        node.tally(Operation::loop_turn, capacity_);
        node.tally(Operation::integer, capacity_);
        for (std::uint32_t i = 0; i < capacity_; ++i) order_[i] = i;
    }

    /// Takes all out; what was counted begins anew.
    void clear() noexcept {
        size_ = 0;
        peak_ = 0;
        overflowed_ = false;
    }
    [[nodiscard]] bool empty() const noexcept { return size_ == 0; }  // whether no cell is in it
    /// The most cells that it holds.
    [[nodiscard]] std::uint32_t capacity() const noexcept { return capacity_; }
    /// The most cells held since clear().
    [[nodiscard]] std::uint32_t peak() const noexcept { return peak_; }
    /// Whether a cell was dropped since clear(), and the smallest of those.
    [[nodiscard]] bool overflowed() const noexcept { return overflowed_; }
    /// Precondition: overflowed().
    [[nodiscard]] const Entry& smallest_dropped() const noexcept { return dropped_; }

    /// Adds a cell, or drops the largest of all.
    void push(const Entry& cell) noexcept {
        node_.tally(Operation::call, 1);
        node_.tally(Operation::integer, 2);
        if (overflowed_ && !before(node_, cell, dropped_)) return;
        if (size_ == capacity_) {
            const std::uint32_t largest = find_largest();
            if (!before(node_, cell, entry(largest))) {
                drop(cell);
                return;
            }
            drop(entry(largest));
            write(largest, cell);
            sift_up(largest);
            return;
        }
        write(size_, cell);
        sift_up(size_++);
        if (peak_ < size_) peak_ = size_;
    }

    /// Removes the smallest cell and copies it to `cell`. Precondition: not empty.
    void pop(Entry& cell) noexcept {
        node_.tally(Operation::call, 1);
        fetch(order_[0], cell);
        swap(0, --size_);
        sift_down();
    }

    /// The slots as plain records: next_after keeps a path of cells in them while the heap is idle.
    void keep(std::uint32_t slot, const Entry& cell) noexcept {
        tally_slow_words(cell);
        move_cell(node_, slots_[slot], cell);
    }
    /// Copies a slot to `cell`.
    void fetch(std::uint32_t slot, Entry& cell) noexcept {
        tally_slow_words(slots_[slot]);
        move_cell(node_, cell, slots_[slot]);
    }

  private:
    [[nodiscard]] Entry& entry(std::uint32_t place) noexcept { return slots_[order_[place]]; }

    void write(std::uint32_t place, const Entry& cell) noexcept { keep(order_[place], cell); }
    /// D stays in fast memory.
    void drop(const Entry& cell) noexcept {
        overflowed_ = true;
        move_cell(node_, dropped_, cell);
    }
    void swap(std::uint32_t a, std::uint32_t b) noexcept {
        const std::uint32_t slot = order_[a];
        order_[a] = order_[b];
        order_[b] = slot;
    }
    /// Pays for the key of a cell that is compared with one whose key is at hand.
    void tally_look() noexcept { node_.tally(Operation::heap_scattered, 1); }
    void tally_slow_words(const Entry& cell) noexcept {
        node_.tally(Operation::heap_scattered, 1);
        node_.tally(Operation::heap_sequential, cell_words(cell) - 1);
    }

    void sift_up(std::uint32_t place) noexcept {
        while (place > 0) {
            const std::uint32_t above = (place - 1) / 2;
            node_.tally(Operation::heap_sift, 1);
            tally_look();
            if (!before(node_, entry(place), entry(above))) return;
            swap(place, above);
            place = above;
        }
    }
    void sift_down() noexcept {
        std::uint32_t place = 0;
        while (true) {
            node_.tally(Operation::heap_sift, 1);
            std::uint32_t smallest = place;
            for (std::uint32_t below = 2 * place + 1; below <= 2 * place + 2; ++below) {
                if (below >= size_) break;
                tally_look();
                if (before(node_, entry(below), entry(smallest))) smallest = below;
            }
            if (smallest == place) return;
            swap(place, smallest);
            place = smallest;
        }
    }
    /// The place of the largest cell: it is among the leaves.
    [[nodiscard]] std::uint32_t find_largest() noexcept {
        tally_look();
        std::uint32_t largest = size_ / 2;
        for (std::uint32_t place = largest + 1; place < size_; ++place) {
            node_.tally(Operation::loop_turn, 1);
            tally_look();
            if (before(node_, entry(largest), entry(place))) largest = place;
        }
        return largest;
    }

    Node& node_;
    std::uint32_t* order_;
    Entry* slots_;
    std::uint32_t capacity_;
    std::uint32_t size_ = 0;
    std::uint32_t peak_ = 0;
    bool overflowed_ = false;
    Entry dropped_;
};

}  // namespace pxm::kernels
