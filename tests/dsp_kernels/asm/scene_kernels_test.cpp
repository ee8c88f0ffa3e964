// Laws of dsp_kernels/asm: kernels that work on cells and on the scene block leave the words that
// their C++ leaves, and none of them reads anything before it is there.
#include "tests/dsp_kernels/asm/scene_kernels.hpp"
#include "tests/dsp_kernels/asm/walk_kernel.hpp"

namespace pxm::kernels {
namespace {

TEST(AsmKernels, fields_of_the_scene_block_lie_where_the_records_have_them) {
    using Header = HeaderRecord<1>;
    using Object = ObjectRecord<1>;
    using Set = FollowSetRecord<1>;
    using Map = MapRecord<1>;
    using Light = LightRecord<1>;
    constexpr std::uint32_t block = 0xA000;
    const std::vector<std::pair<std::string, std::uint32_t>> fields{
        {"block_objects", block + 4 * Header::objects},
        {"block_light_count", block + 4 * Header::light_count},
        {"block_lights", block + 4 * Header::lights},
        {"block_cell_cap", block + 4 * Header::cell_cap},
        {"block_sample_count", block + 4 * Header::sample_count},
        {"block_samples", block + 4 * Header::samples},
        {"block_eye", block + 4 * Header::eye},
        {"block_corner", block + 4 * Header::corner},
        {"block_across", block + 4 * Header::across},
        {"block_down", block + 4 * Header::down},
        {"block_pixel", block + 4 * Header::pixel_at_eye},
        {"block_pixel + 4", block + 4 * Header::pixel_growth},
        {"block_detail", block + 4 * Header::detail},
        {"block_ambient", block + 4 * Header::ambient},
        {"block_background", block + 4 * Header::background},
        {"block_sample_share", block + 4 * Header::sample_share},
        {"object_levels", 4 * Object::levels},
        {"object_inverse", 4 * Object::inverse},
        {"object_constant", 4 * Object::constant},
        {"object_smallest_pixel", 4 * Object::smallest_pixel},
        {"object_color", 4 * Object::color},
        {"object_diffuse", 4 * Object::diffuse},
        {"set_map_count", 4 * Set::map_count},
        {"set_center", 4 * Set::center},
        {"set_center + 12", 4 * Set::radius},
        {"set_low", 4 * Set::low},
        {"set_low + 12", 4 * Set::high},
        {"set_diameter", 4 * Set::diameter},
        {"set_maps", 4 * Set::maps},
        {"map_inverse", 4 * Map::inverse},
        {"map_constant", 4 * Map::constant},
        {"map_color", 4 * Map::color},
        {"light_place", 4 * Light::place},
        {"light_color", 4 * Light::color},
        {"light_bytes", 4 * Light::words}};
    std::string source = text_of_kernel("scene_block") + ".data\n";
    for (const auto& [name, bytes] : fields) source += ".word " + name + "\n";
    dsp32::processor::Program program("field: nop\n" + source);
    for (std::uint32_t i = 0; i < fields.size(); ++i)
        EXPECT_EQ(program.word("field", i + 1), fields[i].second) << fields[i].first;
}
TEST(AsmKernels, a_ray_is_moved_to_a_point_as_by_the_kernel) {
    expect_row("approach", words_of("approach", {"divide"}), try_approach(61, 10'000));
}
TEST(AsmKernels, a_child_is_that_of_the_kernel) {
    const std::string block = text_of_kernel("scene_block");
    expect_row("child", words_of("child", {"transform_ray"}, block), try_child(62, 10'000));
}
TEST(AsmKernels, maps_are_multiplied_as_by_the_kernel) {
    expect_row("compose", words_of("compose", {}), try_compose(63, 10'000));
}
TEST(AsmKernels, a_pixel_is_as_large_as_by_the_kernel) {
    expect_row("pixel_size", words_of("pixel_size", {}), try_pixel_size(64, 10'000));
}
TEST(AsmKernels, a_cell_is_as_large_as_by_the_kernel) {
    try_diameter(Lipschitz::determinant, 65, 5'000);
    expect_row("diameter", words_of("diameter", {}), try_diameter(Lipschitz::product, 66, 5'000));
}
TEST(AsmKernels, a_cell_is_met_as_by_the_kernel) {
    expect_row("meet", words_of("meet", {"approach", "volume"}, ".equ volume_at, 0\n"),
               try_meet(Volume::sphere, 67, 5'000));
}
TEST(AsmKernels, so_is_a_cell_with_a_box) { try_meet(Volume::box, 72, 5'000); }
TEST(AsmKernels, rounding_decides_about_flat_cells_as_by_the_kernel) {
    try_flat_meetings(68, 5'000);
}
TEST(AsmKernels, an_eye_ray_is_that_of_the_kernel) {
    const std::string block = text_of_kernel("scene_block");
    expect_row("eye_ray", words_of("eye_ray", {"normalize"}, block), try_eye_ray(69, 10'000));
}
TEST(AsmKernels, a_surface_is_lit_as_by_the_kernel) {
    const std::string block = text_of_kernel("scene_block");
    expect_row("lambert", words_of("lambert", {}, block), try_lambert(70, 10'000));
}
TEST(AsmKernels, a_cell_is_shaded_along_its_word_as_by_the_kernel) {
    try_walk(Volume::sphere, 73, 1'000);
    try_walk(Volume::box, 74, 1'000);
}
TEST(AsmKernels, a_heap_of_cells_with_words_is_ordered_as_by_the_kernel) {
    const HeapCycles cycles = try_cell_heap(71, 6'000);
    const std::size_t words = words_of("cell_heap", {"cell_heap_full"});
    expect_row("cell_heap_put", words, cycles.push);
    expect_row("cell_heap_take", words, cycles.pop);
}

}  // namespace
}  // namespace pxm::kernels
