// The laws of kernels_test.cpp on a million inputs each.
#include "tests/dsp_kernels/asm/kernels.hpp"

namespace pxm::kernels {
namespace {

constexpr int million = 1'000'000;

TEST(AsmKernels, a_million_reciprocals_are_those_of_the_routine) { try_reciprocal(51, million); }
TEST(AsmKernels, a_million_quotients_are_those_of_the_routine) { try_divide(52, million); }
TEST(AsmKernels, a_million_square_roots_are_those_of_the_routine) { try_square_root(53, million); }
TEST(AsmKernels, a_million_rays_are_transformed_as_by_the_kernel) {
    try_transform_ray(54, million);
}
TEST(AsmKernels, a_million_balls_are_met_as_by_the_kernel) { try_ball(55, million); }
TEST(AsmKernels, a_million_intervals_are_clipped_as_by_the_kernel) { try_slab(56, million); }
TEST(AsmKernels, a_million_roots_below_one_are_those_of_the_routine) {
    try_reciprocal_square_root(58, million);
}
TEST(AsmKernels, a_million_vectors_are_normalized_as_by_the_kernel) { try_normalize(59, million); }
TEST(AsmKernels, a_million_boxes_are_met_as_by_the_kernel) { try_box(60, million); }
TEST(AsmKernels, a_heap_is_ordered_as_by_the_kernel_for_a_million_steps) { try_heap(57, million); }

}  // namespace
}  // namespace pxm::kernels
