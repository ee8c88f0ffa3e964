// Laws of a node's fast memory: program, heap's order and stack share 36,864 bytes.
#include <gtest/gtest.h>

#include "pxm/machine.hpp"

namespace pxm {
namespace {

TEST(FastMemory, the_heaps_order_lies_after_the_program_and_leaves_the_stack_alone) {
    Node<float> node({0, 0}, 0);
    EXPECT_FALSE(node.load_program(1000, 600));
    EXPECT_FALSE(node.reserve_heap(256, 316));
    std::uint32_t* memory = node.fast_memory().records<std::uint32_t>(0);
    EXPECT_EQ(node.heap_order(), memory + 1000 / 4);
    EXPECT_EQ(node.fast_memory().used_bytes(), 1000 + heap_order_bytes(256) + 600);
}

TEST(FastMemory, the_heaps_entries_take_none_of_it) {
    Node<float> small({0, 0}, 0);
    Node<float> large({0, 0}, 0);
    EXPECT_FALSE(small.reserve_heap(100, 80));
    EXPECT_FALSE(large.reserve_heap(100, 320));
    EXPECT_EQ(small.fast_memory().used_bytes(), large.fast_memory().used_bytes());
    EXPECT_EQ(large.zbuffer().used_bytes(), 100 * 320);
}

TEST(FastMemory, one_word_more_than_there_is_is_a_fault) {
    constexpr std::int64_t stack = 2000;
    constexpr int entries = 100;
    const std::int64_t program = fast_memory_bytes - stack - heap_order_bytes(entries);
    Node<float> fits({0, 0}, 0);
    EXPECT_FALSE(fits.load_program(program, stack));
    EXPECT_FALSE(fits.reserve_heap(entries, 16));
    EXPECT_EQ(fits.fast_memory().used_bytes(), fast_memory_bytes);

    Node<float> over({3, 2}, 19);
    EXPECT_FALSE(over.load_program(program + 4, stack));
    const std::optional<Fault> fault = over.reserve_heap(entries, 16);
    ASSERT_TRUE(fault);
    EXPECT_EQ(fault->bank, "fast memory");
    EXPECT_EQ(fault->node, 19);
    EXPECT_EQ(fault->wanted_bytes, fast_memory_bytes + 4);
    EXPECT_EQ(fault->limit_bytes, fast_memory_bytes);
}

TEST(FastMemory, a_program_that_is_too_large_is_not_loaded) {
    Machine<float> machine(*find_model("916"));
    EXPECT_FALSE(machine.load_program(fast_memory_bytes - 64, 64));
    EXPECT_TRUE(machine.load_program(fast_memory_bytes - 64, 65));
}

}  // namespace
}  // namespace pxm
