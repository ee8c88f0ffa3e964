// What a node counts while it runs: operations by kind. The cost table (pxm/cost.hpp) turns the
// counts into instruction cycles.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace pxm {

/// Operations of a node program, in the units of machine-facts (docs/machine.md, "Counted time").
enum class Operation : std::uint8_t {
    multiply_add,         // one float add, subtract, multiply or multiply-add
    dot_product,          // of two 3-vectors
    transform_point,      // point times a 3x4 affine matrix
    transform_direction,  // direction times a 3x3 matrix
    compare_branch,       // float compare and branch
    select,               // float minimum, maximum, magnitude, conditional move
    to_float,             // an integer as a float
    reciprocal,
    divide,
    square_root,
    reciprocal_square_root,
    integer,  // integer add, logic, compare; a move of a word
    loop_turn,
    call,              // call and return of a routine
    shape_sequential,  // a word of the back frame buffer next to the one read before
    shape_scattered,   // a word elsewhere in the back frame buffer
    heap_sequential,   // the same in the z-buffer memory
    heap_scattered,
    heap_sift,           // one step of a heap's sift, its comparisons and slow words counted apart
    pixel_write,         // pack four bytes and store them
    pixel_sequential,    // the word of the front frame buffer next to the pixel before
    texture_sequential,  // a word of the texture memory next to the one read before
    texture_scattered,   // a word elsewhere in the texture memory
};
inline constexpr std::size_t operation_count = 23;  // kinds of operations

/// Names as they stand in cost tables and statistics.
inline constexpr std::array<std::string_view, operation_count> operation_names{
    "multiply_add",
    "dot_product",
    "transform_point",
    "transform_direction",
    "compare_branch",
    "select",
    "to_float",
    "reciprocal",
    "divide",
    "square_root",
    "reciprocal_square_root",
    "integer",
    "loop_turn",
    "call",
    "shape_sequential",
    "shape_scattered",
    "heap_sequential",
    "heap_scattered",
    "heap_sift",
    "pixel_write",
    "pixel_sequential",
    "texture_sequential",
    "texture_scattered"};

/// Whether the node waits for one of its slow memories instead of executing an instruction.
[[nodiscard]] constexpr bool is_memory_wait(Operation operation) noexcept {
    switch (operation) {
        case Operation::shape_sequential:
        case Operation::shape_scattered:
        case Operation::heap_sequential:
        case Operation::heap_scattered:
        case Operation::pixel_sequential:
        case Operation::texture_sequential:
        case Operation::texture_scattered:
            return true;
        default:
            return false;
    }
}

/// Counts of one node.
struct Tally {
    std::array<std::uint64_t, operation_count> counts{};  // by Operation

    /// Counts operations of one kind.
    void add(Operation operation, std::uint64_t times) noexcept {
        counts[static_cast<std::size_t>(operation)] += times;
    }
    /// Adds what another has counted.
    void add(const Tally& other) noexcept {
        for (std::size_t i = 0; i < operation_count; ++i) counts[i] += other.counts[i];
    }
};

}  // namespace pxm
