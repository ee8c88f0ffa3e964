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
    compose_linear,       // 3x3 times 3x3
    compare_branch,       // float compare and branch
    select,               // float minimum, maximum, conditional move
    reciprocal,
    divide,
    square_root,
    normalize,  // reciprocal square root and three multiplies
    integer,    // integer add, logic, compare, move
    loop_turn,
    call,              // call and return of a routine
    shape_sequential,  // a word of the back frame buffer next to the one read before
    shape_scattered,   // a word elsewhere in the back frame buffer
    heap_sequential,   // the same in the z-buffer memory
    heap_scattered,
    heap_sift,    // one step of a heap's sift, entries moved by index
    pixel_write,  // pack four bytes and store them in the front frame buffer
};
inline constexpr std::size_t operation_count = 20;

/// Names as they stand in cost tables and statistics.
inline constexpr std::array<std::string_view, operation_count> operation_names{
    "multiply_add",    "dot_product",    "transform_point",  "transform_direction",
    "compose_linear",  "compare_branch", "select",           "reciprocal",
    "divide",          "square_root",    "normalize",        "integer",
    "loop_turn",       "call",           "shape_sequential", "shape_scattered",
    "heap_sequential", "heap_scattered", "heap_sift",        "pixel_write"};

/// Counts of one node.
struct Tally {
    std::array<std::uint64_t, operation_count> counts{};

    void add(Operation operation, std::uint64_t times) noexcept {
        counts[static_cast<std::size_t>(operation)] += times;
    }
};

}  // namespace pxm
