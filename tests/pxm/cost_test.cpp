// Laws of pxm/cost.
#include "pxm/cost.hpp"

#include <gtest/gtest.h>

#include <set>

namespace pxm {
namespace {

std::size_t index_of(Operation operation) { return static_cast<std::size_t>(operation); }

TEST(Cost, every_operation_has_one_entry_with_its_mark_source_and_sentence) {
    std::set<std::string_view> names;
    for (std::size_t i = 0; i < operation_count; ++i) {
        const CostEntry& entry = default_cost_entries()[i];
        EXPECT_EQ(index_of(entry.operation), i);
        EXPECT_FALSE(operation_names[i].empty());
        EXPECT_TRUE(names.insert(operation_names[i]).second) << operation_names[i];
        EXPECT_FALSE(entry.sentence.empty()) << operation_names[i];
        EXPECT_EQ(entry.certainty == Certainty::assumed, entry.source.empty())
            << operation_names[i];
    }
}

TEST(Cost, hand_scheduled_is_never_slower_than_plain) {
    for (const CostEntry& entry : default_cost_entries()) {
        EXPECT_GT(entry.cost.tight, 0);
        EXPECT_LE(entry.cost.tight, entry.cost.plain);
    }
}

TEST(Cost, the_share_of_plain_code_mixes_the_columns) {
    CostTable table = default_cost_table();
    EXPECT_EQ(table.cycles_of(Operation::compare_branch), 4.5);
    table.plain_share = 0;
    EXPECT_EQ(table.cycles_of(Operation::compare_branch), 3);
    table.plain_share = 1;
    EXPECT_EQ(table.cycles_of(Operation::compare_branch), 6);
}

TEST(Cost, compiled_code_has_more_instructions_and_no_more_waits) {
    CostTable table = default_cost_table();
    Tally tally;
    tally.add(Operation::multiply_add, 100);
    tally.add(Operation::shape_scattered, 10);
    EXPECT_EQ(instructions(tally, table), 100U);
    EXPECT_EQ(cycles(tally, table), 130U);
    table.compiled_code_factor = 3;
    EXPECT_EQ(instructions(tally, table), 300U);
    EXPECT_EQ(cycles(tally, table), 330U);
}

TEST(Cost, the_slow_memories_alone_are_waited_for) {
    for (std::size_t i = 0; i < operation_count; ++i) {
        const std::string_view name = operation_names[i];
        EXPECT_EQ(is_memory_wait(static_cast<Operation>(i)),
                  name.ends_with("_sequential") || name.ends_with("_scattered"))
            << name;
    }
}

TEST(Cost, half_cycles_are_rounded_once_in_the_sum) {
    Tally tally;
    tally.add(Operation::compare_branch, 2);  // 4.5 each
    EXPECT_EQ(cycles(tally, default_cost_table()), 9U);
}

}  // namespace
}  // namespace pxm
