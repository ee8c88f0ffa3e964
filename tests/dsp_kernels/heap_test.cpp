// The heap of cells against a sorted list (Def. 12.1): bounded, the smallest first, and what was
// dropped is known by its smallest.
#include "dsp_kernels/heap.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <random>

#include "host/node_program/native_node.hpp"

namespace pxm::test {
namespace {

using Node = host::NativeNode<double>;
using Cell = kernels::Cell<double>;

constexpr std::uint32_t maps_bits = 3;

/// What the heap is to do, with all cells in order.
struct SortedList {
    Node& node;
    std::size_t capacity;
    std::vector<Cell> cells;
    std::optional<Cell> dropped;

    void push(const Cell& cell) {
        const auto is_before = [&](const Cell& a, const Cell& b) { return before(node, a, b); };
        if (dropped && !is_before(cell, *dropped)) return;
        cells.insert(std::upper_bound(cells.begin(), cells.end(), cell, is_before), cell);
        if (cells.size() <= capacity) return;
        dropped = cells.back();
        cells.pop_back();
    }
};

/// Few keys, objects and symbols, so that many cells agree in some of them.
Cell random_cell(std::mt19937& random) {
    Cell cell;
    cell.key = static_cast<double>(random() % 5);
    cell.object = static_cast<std::uint32_t>(random() % 2);
    cell.bits = maps_bits;
    cell.level = static_cast<std::uint16_t>(4 + random() % 3);
    for (std::uint32_t i = 0; i < cell.level; ++i)
        cell.word.set(i, maps_bits, static_cast<std::uint32_t>(random() % 8));
    return cell;
}

bool same(Node& node, const Cell& a, const Cell& b) {
    return !before(node, a, b) && !before(node, b, a);
}

TEST(Heap, holds_the_smallest_cells_in_order_as_a_sorted_list_does) {
    std::mt19937 random(7);
    for (const int capacity : {1, 2, 3, 8, 256}) {
        for (int trial = 0; trial < 40; ++trial) {
            Node node({}, {}, capacity, sizeof(Cell));
            kernels::Heap<Node> heap(node);
            heap.clear();
            SortedList list{node, static_cast<std::size_t>(capacity), {}, {}};
            std::size_t peak = 0;
            for (int step = 0; step < 400; ++step) {
                if (random() % 3 != 0) {
                    const Cell cell = random_cell(random);
                    heap.push(cell);
                    list.push(cell);
                } else if (!list.cells.empty()) {
                    Cell top;
                    heap.pop(top);
                    ASSERT_TRUE(same(node, top, list.cells.front()));
                    list.cells.erase(list.cells.begin());
                }
                peak = std::max(peak, list.cells.size());
                ASSERT_EQ(heap.empty(), list.cells.empty());
                ASSERT_EQ(heap.peak(), peak);
                ASSERT_EQ(heap.overflowed(), list.dropped.has_value());
                if (list.dropped) {
                    ASSERT_TRUE(same(node, heap.smallest_dropped(), *list.dropped));
                }
            }
        }
    }
}

}  // namespace
}  // namespace pxm::test
