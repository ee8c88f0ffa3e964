// Laws of dsp_kernels/asm: every kernel in assembler leaves the words that its C++ leaves, and
// none of them reads anything before it is there.
#include "tests/dsp_kernels/asm/kernels.hpp"

namespace pxm::kernels {
namespace {

TEST(AsmKernels, the_reciprocal_is_that_of_the_routine) {
    expect_row("reciprocal", words_of("reciprocal", {}), try_reciprocal(41, 20'000));
}
TEST(AsmKernels, the_quotient_is_that_of_the_routine) {
    expect_row("divide", words_of("divide", {}), try_divide(42, 20'000));
}
TEST(AsmKernels, the_square_root_is_that_of_the_routine) {
    expect_row("square_root", words_of("square_root", {}), try_square_root(43, 20'000));
}
TEST(AsmKernels, one_over_the_root_is_that_of_the_routine) {
    expect_row("reciprocal_square_root", words_of("reciprocal_square_root", {}),
               try_reciprocal_square_root(48, 20'000));
}
TEST(AsmKernels, a_vector_is_normalized_as_by_the_kernel) {
    expect_row("normalize", words_of("normalize", {"reciprocal", "reciprocal_square_root"}),
               try_normalize(49, 10'000));
}
TEST(AsmKernels, a_box_is_met_as_by_the_kernel) {
    expect_row("box", words_of("box", {"slab"}), try_box(50, 10'000));
}
TEST(AsmKernels, a_ray_is_transformed_as_by_the_kernel) {
    expect_row("transform_ray", words_of("transform_ray", {}), try_transform_ray(44, 10'000));
}
TEST(AsmKernels, a_ball_is_met_as_by_the_kernel) {
    expect_row("ball", words_of("ball", {"divide", "square_root"}), try_ball(45, 10'000));
}
TEST(AsmKernels, an_interval_is_clipped_as_by_the_kernel) {
    expect_row("slab", words_of("slab", {"reciprocal"}), try_slab(46, 10'000));
}
TEST(AsmKernels, a_heap_of_cells_is_ordered_as_by_the_kernel) {
    const HeapCycles cycles = try_heap(47, 4'000);
    const std::size_t words = words_of("heap", {});
    expect_row("heap_push", words, cycles.push);
    expect_row("heap_pop", words, cycles.pop);
}

}  // namespace
}  // namespace pxm::kernels
