// The laws of kernels_test.cpp and scene_kernels_test.cpp on many random inputs: a hundred thousand
// of each among the slow tests, a million among the full ones.
#pragma once

#include <gtest/gtest.h>

#include "tests/dsp_kernels/asm/kernels.hpp"
#include "tests/dsp_kernels/asm/scene_kernels.hpp"
#include "tests/dsp_kernels/asm/walk_kernel.hpp"

namespace pxm::kernels {

class AsmKernelsOnManyInputs : public testing::TestWithParam<int> {};

TEST_P(AsmKernelsOnManyInputs, give_the_reciprocals_of_the_routine) {
    try_reciprocal(51, GetParam());
}
TEST_P(AsmKernelsOnManyInputs, give_the_quotients_of_the_routine) { try_divide(52, GetParam()); }
TEST_P(AsmKernelsOnManyInputs, give_the_square_roots_of_the_routine) {
    try_square_root(53, GetParam());
}
TEST_P(AsmKernelsOnManyInputs, transform_rays_as_the_kernel) { try_transform_ray(54, GetParam()); }
TEST_P(AsmKernelsOnManyInputs, meet_balls_as_the_kernel) { try_ball(55, GetParam()); }
TEST_P(AsmKernelsOnManyInputs, clip_intervals_as_the_kernel) { try_slab(56, GetParam()); }
TEST_P(AsmKernelsOnManyInputs, order_a_heap_as_the_kernel) { try_heap(57, GetParam()); }
TEST_P(AsmKernelsOnManyInputs, give_the_roots_below_one_of_the_routine) {
    try_reciprocal_square_root(58, GetParam());
}
TEST_P(AsmKernelsOnManyInputs, normalize_vectors_as_the_kernel) { try_normalize(59, GetParam()); }
TEST_P(AsmKernelsOnManyInputs, meet_boxes_as_the_kernel) { try_box(60, GetParam()); }
TEST_P(AsmKernelsOnManyInputs, move_rays_as_the_kernel) { try_approach(81, GetParam()); }
TEST_P(AsmKernelsOnManyInputs, make_the_children_of_the_kernel) { try_child(82, GetParam()); }
TEST_P(AsmKernelsOnManyInputs, multiply_maps_as_the_kernel) { try_compose(83, GetParam()); }
TEST_P(AsmKernelsOnManyInputs, tell_the_size_of_a_pixel_as_the_kernel) {
    try_pixel_size(84, GetParam());
}
TEST_P(AsmKernelsOnManyInputs, tell_the_size_of_a_cell_as_the_kernel) {
    try_diameter(Lipschitz::product, 85, GetParam());
    try_diameter(Lipschitz::determinant, 86, GetParam());
}
TEST_P(AsmKernelsOnManyInputs, meet_cells_with_balls_as_the_kernel) {
    try_meet(Volume::sphere, 87, GetParam());
}
TEST_P(AsmKernelsOnManyInputs, meet_cells_with_boxes_as_the_kernel) {
    try_meet(Volume::box, 92, GetParam());
}
TEST_P(AsmKernelsOnManyInputs, meet_flat_cells_as_the_kernel) { try_flat_meetings(88, GetParam()); }
TEST_P(AsmKernelsOnManyInputs, make_the_eye_rays_of_the_kernel) { try_eye_ray(89, GetParam()); }
TEST_P(AsmKernelsOnManyInputs, light_surfaces_as_the_kernel) { try_lambert(90, GetParam()); }
TEST_P(AsmKernelsOnManyInputs, order_a_heap_of_cells_with_words_as_the_kernel) {
    try_cell_heap(91, GetParam());
}
TEST_P(AsmKernelsOnManyInputs, shade_cells_with_balls_as_the_kernel) {
    try_walk(Volume::sphere, 93, GetParam());
}
TEST_P(AsmKernelsOnManyInputs, shade_cells_with_boxes_as_the_kernel) {
    try_walk(Volume::box, 94, GetParam());
}

}  // namespace pxm::kernels
