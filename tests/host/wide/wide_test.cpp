// The wide engine shows an admissible picture (docs/design.md, decision 4): small images of every
// example scene; wide_slow_test.cpp has larger ones. It is judged as a double engine is: what its
// rays share is kept in double, so p has the floor of double.
#include <gtest/gtest.h>

#include <hwy/targets.h>

#include <algorithm>

#include "host/wide/tables/eligible.hpp"
#include "host/wide/tile/wide_engine.hpp"
#include "tests/support/compile_text.hpp"
#include "tests/support/example_scenes.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/referee.hpp"
#include "tests/support/render_text.hpp"

namespace pxm::test {
namespace {

using namespace host;

Frame render_wide(const CompiledScene& scene, int threads = 1) {
    EngineChoice choice;
    choice.threads = threads;
    return wide::run_wide(scene, choice, {}).frame;
}

class Wide : public testing::TestWithParam<Example> {
  protected:
    const CompiledScene scene_ = compile_text(GetParam().text);
};

TEST_P(Wide, is_admissible) {
    if (!wide::why_not_wide(scene_, Numeric::single).empty()) GTEST_SKIP();
    const Verdict verdict = judge(scene_, render_wide(scene_), Numeric::double_);
    EXPECT_GT(verdict.hits, 0);
    EXPECT_GE(verdict.admissible_share(), 0.999) << verdict.report;
    EXPECT_EQ(verdict.wrong_colors, 0) << verdict.report;
}

TEST_P(Wide, is_the_same_on_every_kind_of_register_and_for_any_number_of_threads) {
    if (!wide::why_not_wide(scene_, Numeric::single).empty()) GTEST_SKIP();
    const Frame widest = render_wide(scene_, 3);
    for (const int64_t target : {HWY_AVX3, HWY_AVX2, HWY_SSE4, HWY_EMU128}) {
        if ((hwy::SupportedTargets() & target) == 0) continue;
        hwy::SetSupportedTargetsForTest(target);
        const Frame frame = render_wide(scene_);
        hwy::SetSupportedTargetsForTest(0);
        EXPECT_TRUE(same_picture(widest, frame)) << hwy::TargetName(target);
    }
}

/// What other rays have left in the lanes beyond the last one tells nothing of a ray: with the eye
/// inside, some have entered shared cells so near their start that their path is walked in double.
TEST(WideTiles, are_the_same_whatever_was_rendered_before_them) {
    RenderRequest request;
    request.scene_path = source_dir + "/scenes/icos.pxm";
    request.settings = {{"camera.eye", "0.1,0.05,-0.3"}};
    request.overrides.intersect = IntersectMethod::wide;
    request.overrides.size = PixelSize{200, 200};
    const Frame whole = render(request, {}).frame;
    for (long top = 0; top < 200; top += 2 * tile_side) {
        request.overrides.crop = CropWindow{0, top, 200, std::min(200L, top + 2 * tile_side)};
        const Frame part = render(request, {}).frame;
        Frame expected(whole.size, part.crop);
        for (long y = part.crop.y0; y < part.crop.y1; ++y)
            std::copy_n(&whole.at(0, y), 200, &expected.at(0, y));
        EXPECT_TRUE(same_picture(expected, part)) << "from row " << top;
    }
}

/// The terminal balls stand out of the attractor's hull by half a pixel, and are seen there too.
TEST(WideBalls, are_seen_beside_the_hull) {
    for (const char* system : {"tetra", "octo"}) {
        const CompiledScene scene =
            compile_text(scene_of(system, "volume: sphere", "size: 280,210"));
        EngineChoice clear;
        clear.numeric = Numeric::double_;
        clear.intersect = IntersectMethod::heap;
        const Frame expected = run_reference(scene, clear, {}).frame;
        const Frame found = render_wide(scene);
        long lost = 0;
        for (std::size_t i = 0; i < found.pixels.size(); ++i) {
            if (expected.pixels[i].object >= 0 && found.pixels[i].object < 0) ++lost;
        }
        EXPECT_EQ(lost, 0) << system;
    }
}

/// The eye comes as near as 10^-7 of its distance: single precision alone would see nothing there.
TEST(WideZoom, is_right_to_the_last_pixel) {
    const std::string camera = "camera { eye: 0.4,1.6,-3 look: 0,1,0 fov: 40 }";
    for (const char* system : {"tetra", "menger", "elm"}) {
        for (const double zoom : {1e2, 1e4, 1e7}) {
            const CompiledScene scene =
                compile_text(scene_of(system, "", "size: 16,16") + camera, zoom);
            const Verdict verdict = judge(scene, render_wide(scene), Numeric::double_);
            EXPECT_EQ(verdict.admissible, verdict.pixels) << system << zoom << verdict.report;
            EXPECT_EQ(verdict.wrong_colors, 0) << system << zoom << verdict.report;
        }
    }
}

/// Lanes divide by zero where they have no child; that is no alarm of the pixels that the clear
/// kernels judge in their stead.
TEST(WideAlarms, tell_of_no_overflow_that_was_none) {
    RenderRequest request;
    request.scene_path = test::source_dir + "/scenes/deep_zoom.pxm";
    request.overrides.size = PixelSize{320, 240};
    request.overrides.zoom = 1e30;
    const RenderResult result = render(request, {});
    EXPECT_EQ(result.statistics.intersect, "wide");
    EXPECT_EQ(result.warnings, "");
}

TEST(WideChoice, says_why_not) {
    const auto reason = [](const std::string& text, Numeric numeric = Numeric::single) {
        return wide::why_not_wide(compile_text(text), numeric);
    };
    EXPECT_EQ(reason(scene_of("tetra")), "");
    EXPECT_EQ(reason(scene_of("elm")), "");
    EXPECT_EQ(reason(scene_of("grass")), "object \"grass\" has maps that squash very much");
    EXPECT_EQ(reason(scene_of("tetra"), Numeric::double_),
              "the numbers are double, and the wide engine's are float");
    EXPECT_EQ(reason(scene_of("tetra", "samples: 4")), "");
    EXPECT_EQ(reason(scene_of("tetra", "covers: on")),
              "local covers by diameter and translucent objects are the reference kernels'");
    EXPECT_EQ(reason(scene_of("tetra", "volume: hull")),
              "object \"tetra\" has bounding volumes that are neither balls nor boxes");
}

std::string name_of(const testing::TestParamInfo<Example>& example) { return example.param.name; }

INSTANTIATE_TEST_SUITE_P(Examples, Wide, testing::ValuesIn(example_scenes("20,15")), name_of);

}  // namespace
}  // namespace pxm::test
