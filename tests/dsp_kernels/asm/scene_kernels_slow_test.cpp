// The laws of scene_kernels_test.cpp on a million inputs each.
#include "tests/dsp_kernels/asm/scene_kernels.hpp"
#include "tests/dsp_kernels/asm/walk_kernel.hpp"

namespace pxm::kernels {
namespace {

constexpr int million = 1'000'000;

TEST(AsmKernels, a_million_rays_are_moved_as_by_the_kernel) { try_approach(81, million); }
TEST(AsmKernels, a_million_children_are_those_of_the_kernel) { try_child(82, million); }
TEST(AsmKernels, a_million_products_of_maps_are_those_of_the_kernel) { try_compose(83, million); }
TEST(AsmKernels, a_million_pixels_are_as_large_as_by_the_kernel) { try_pixel_size(84, million); }
TEST(AsmKernels, a_million_cells_are_as_large_as_by_the_kernel) {
    try_diameter(Lipschitz::product, 85, million);
    try_diameter(Lipschitz::determinant, 86, million);
}
TEST(AsmKernels, a_million_cells_are_met_as_by_the_kernel) {
    try_meet(Volume::sphere, 87, million);
    try_meet(Volume::box, 92, million);
    try_flat_meetings(88, million);
}
TEST(AsmKernels, a_million_eye_rays_are_those_of_the_kernel) { try_eye_ray(89, million); }
TEST(AsmKernels, a_million_surfaces_are_lit_as_by_the_kernel) { try_lambert(90, million); }
TEST(AsmKernels, a_million_cells_are_shaded_along_their_words_as_by_the_kernel) {
    try_walk(Volume::sphere, 93, million);
    try_walk(Volume::box, 94, million);
}
TEST(AsmKernels, a_million_cells_with_words_are_ordered_as_by_the_kernel) {
    try_cell_heap(91, million);
}

}  // namespace
}  // namespace pxm::kernels
