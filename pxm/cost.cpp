#include "pxm/cost.hpp"

#include <cmath>

namespace pxm {

namespace {

using enum Operation;
using enum Certainty;

// clang-format off
constexpr std::array<CostEntry, operation_count> entries{{
    // operation, {tight, plain}, mark, source, sentence
    {multiply_add, {1, 1}, seen, "S7, S8", "a float add, subtract, multiply or multiply-add"},
    {dot_product, {3, 5}, derived, "S7, S8", "of two 3-vectors: three multiply-adds, the latency of the last"},
    {transform_point, {9, 12}, derived, "S7, S8", "a point times a 3x4 matrix, the translation as first addend"},
    {transform_direction, {9, 12}, derived, "S7, S8", "a direction times a 3x3 matrix; composing two takes three"},
    {compare_branch, {3, 6}, derived, "S7, S8", "subtract, three idle, branch, its slot"},
    {select, {2, 2}, derived, "S8", "subtract and conditional move: minimum, maximum, magnitude"},
    {to_float, {1, 4}, derived, "S7", "an integer as a float, plain: through memory"},
    {reciprocal, {20, 22}, derived, "S9", "the routine of 14, and 6 for the missing seed instruction"},
    {divide, {22, 24}, derived, "S9", "the routine of 16, and 6 for the missing seed instruction"},
    {square_root, {55, 60}, assumed, "", "to about 23 bits: the routine of 13 bits (38) and one more Newton step"},
    {reciprocal_square_root, {30, 45}, assumed, "", "a seed and two Newton steps"},
    {integer, {1, 1}, seen, "S7", "an integer add, logic or compare; a move of a word"},
    {loop_turn, {1, 2}, seen, "S7, S8", "decrement and branch, its slot used or not"},
    {call, {3, 4}, seen, "S7, S8", "call and return, their slots used or not"},
    {shape_sequential, {1, 1}, assumed, "", "wait for a word of the back frame buffer next to the one before"},
    {shape_scattered, {3, 3}, assumed, "", "wait for a word elsewhere in it: the window is set"},
    {heap_sequential, {1, 1}, assumed, "", "wait for a word of the z-buffer memory next to the one before"},
    {heap_scattered, {3, 3}, assumed, "", "wait for a word elsewhere in it"},
    {heap_sift, {9, 14}, assumed, "", "a step of a sift: addresses and numbers; 12 and 20 less a comparison"},
    {pixel_write, {8, 14}, assumed, "", "pack four bytes and store them"},
    {pixel_sequential, {1, 1}, assumed, "", "wait for a word of the front frame buffer next to the one before"},
    {texture_sequential, {1, 1}, assumed, "", "wait for a word of the texture memory next to the one before"},
    {texture_scattered, {3, 3}, assumed, "", "wait for a word elsewhere in it"},
}};
// clang-format on

constexpr CostTable table_of_entries() {
    CostTable table{};
    for (const CostEntry& entry : entries) {
        table.operations[static_cast<std::size_t>(entry.operation)] = entry.cost;
    }
    return table;
}

template <class Wanted>
std::uint64_t sum(const Tally& tally, const CostTable& table, const Wanted& wanted) noexcept {
    double total = 0;
    for (std::size_t i = 0; i < operation_count; ++i) {
        const auto operation = static_cast<Operation>(i);
        if (!wanted(operation)) continue;
        total += static_cast<double>(tally.counts[i]) * table.cycles_of(operation);
    }
    return static_cast<std::uint64_t>(std::llround(total));
}

}  // namespace

std::span<const CostEntry, operation_count> default_cost_entries() noexcept { return entries; }

const CostTable& default_cost_table() noexcept {
    static constexpr CostTable table = table_of_entries();
    return table;
}

CostModel default_cost_model() { return {"default", default_cost_table()}; }

std::uint64_t cycles(const Tally& tally, const CostTable& table) noexcept {
    return sum(tally, table, [](Operation) { return true; });
}

std::uint64_t instructions(const Tally& tally, const CostTable& table) noexcept {
    return sum(tally, table, [](Operation operation) { return !is_memory_wait(operation); });
}

}  // namespace pxm
