// Laws of what the wide engine keeps of a tile: tables have bounds, and beyond them pixels are the
// reference kernels'.
#include <gtest/gtest.h>

#include "host/wide/search/packet_search.hpp"
#include "host/wide/tables/eligible.hpp"
#include "host/wide/tile/wide_engine.hpp"
#include "tests/support/compile_text.hpp"
#include "tests/support/render_text.hpp"

namespace pxm::host::wide {
namespace {

std::string tiny_pixels(const std::string& maps, const std::string& volume) {
    return "ifs a { newmap scale: 0.5 translate: 0,0.5,0\nnewmap scale: 0.5 " + maps +
           " translate: 0.5,-0.25,0\nnewmap scale: 0.5 translate: -0.5,-0.25,0.3\n"
           "newmap scale: 0.5 translate: 0,-0.25,-0.5 }\n"
           "image { size: 8,8 } render { detail: 1e-4 volume: " +
           volume + " }";
}

class TinyPixels : public testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(TinyPixels, do_not_fill_the_memory_with_shared_cells) {
    const auto [maps, volume] = GetParam();
    const CompiledScene scene = test::compile_text(tiny_pixels(maps, volume));
    ASSERT_EQ(why_not_wide(scene, Numeric::single), "");
    const WideScene wide = make_wide_scene(scene);
    SearchWorkspace work;
    work.scratch = hwy::AllocateAligned<double>(std::size_t{table_step} * 32);
    aim_at_tile(work.packet, scene.camera, scene.crop, {0, 0}, {0.5, 0.5});
    ASSERT_TRUE(search_packet(wide, work));
    EXPECT_LE(work.cells.size() + work.homothety_cells.size(), most_shared_cells + most_maps);
    EXPECT_GT(std::ranges::count_if(work.found, &Found::given_up), 0);
}

TEST_P(TinyPixels, show_what_the_clear_kernels_show) {
    const auto [maps, volume] = GetParam();
    const CompiledScene scene = test::compile_text(tiny_pixels(maps, volume));
    const Frame wide = run_wide(scene, {}, {}).frame;
    const Frame clear = test::render_natively(scene, Numeric::double_).frame;
    for (std::size_t i = 0; i < wide.pixels.size(); ++i) {
        EXPECT_EQ(wide.pixels[i].object, clear.pixels[i].object) << "pixel " << i;
    }
}

INSTANTIATE_TEST_SUITE_P(Volumes, TinyPixels,
                         testing::Values(std::pair{"", "sphere"}, std::pair{"", "box"},
                                         std::pair{"rotate: z,20", "sphere"},
                                         std::pair{"rotate: z,20", "box"}));

TEST(CandidateViews, of_very_many_lights_are_few) {
    std::string text =
        "ifs a { newmap scale: 0.5  newmap scale: 0.5 translate: 1,0,0\n"
        "newmap scale: 0.5 translate: 0,1,0 }\nimage { size: 8,8 }\n";
    for (int i = 1; i <= 300; ++i) {
        text += "light { direction: " + std::to_string(i) + ",1,-9 shadow: on }\n";
    }
    const CompiledScene scene = test::compile_text(text);
    const WideScene wide = make_wide_scene(scene);
    std::vector<CandidateView> candidate_views;
    RayPacket packet;
    packet.candidate_view = {CandidateViewOf::Kind::light, 299, 0};
    packet.axis[0] = {1, 0, 0};
    packet.axis[1] = {0, 1, 0};
    packet.axis[2] = {0, 0, 1};
    EXPECT_FALSE(candidate_view_of(wide, packet, candidate_views).view.shared);
    EXPECT_LE(candidate_views.size(), 8U);
}

}  // namespace
}  // namespace pxm::host::wide
