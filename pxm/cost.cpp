#include "pxm/cost.hpp"

#include <cmath>

namespace pxm {

const CostTable& default_cost_table() {
    static constexpr CostTable table{{{
        // tight, plain
        {1, 1},    // multiply_add
        {3, 5},    // dot_product
        {9, 12},   // transform_point
        {9, 12},   // transform_direction
        {27, 36},  // compose_linear: three direction transforms
        {3, 6},    // compare_branch
        {2, 2},    // select
        {20, 22},  // reciprocal
        {22, 24},  // divide
        {55, 60},  // square_root, to about 23 bits
        {30, 45},  // normalize
        {1, 1},    // integer
        {1, 2},    // loop_turn
        {3, 4},    // call: call and return, the slots used or not
        {1, 1},    // shape_sequential: the extra over a fast word
        {3, 3},    // shape_scattered
        {1, 1},    // heap_sequential
        {3, 3},    // heap_scattered
        {12, 20},  // heap_sift, its two slow accesses counted as heap_scattered
        {8, 14},   // pixel_write, its slow access within
    }}};
    return table;
}

std::uint64_t cycles(const Tally& tally, const CostTable& table) noexcept {
    double sum = 0;
    for (std::size_t i = 0; i < operation_count; ++i) {
        sum += static_cast<double>(tally.counts[i]) * table.cycles_of(static_cast<Operation>(i));
    }
    return static_cast<std::uint64_t>(std::llround(sum));
}

}  // namespace pxm
