// Shadows, mirrors, planes and samples of the wide engine: what the reference kernels see in
// double. Where a shadow falls along the edge of a cell, or a mirror shows one, rounding decides.
#include <gtest/gtest.h>

#include <hwy/targets.h>

#include <cmath>

#include "host/wide/tables/eligible.hpp"
#include "host/wide/tile/wide_engine.hpp"
#include "tests/support/compile_text.hpp"
#include "tests/support/example_scenes.hpp"
#include "tests/support/render_text.hpp"

namespace pxm::test {
namespace {

using namespace host;

struct Feature {
    std::string name;
    std::string text;  // added to a system
    std::string render;
};
void PrintTo(const Feature& feature, std::ostream* out) { *out << feature.name; }

constexpr const char* floor_below = "plane floor { point: 0,-0.6,0 normal: 0,1,0 color: 1,0.9,0.7 ";
constexpr const char* sun = "light sun { direction: -0.5,1,-0.7 shadow: on }";

std::vector<Feature> features() {
    const std::string floor = std::string(floor_below) + "}";
    const std::string wood =
        "texture boards { wood size: 0.5,0.1 color: 1,0.5,0.2 color2: "
        "0.3,0.2,0.1 } plane floor { point: 0,-0.6,0 normal: 0,1,0 texture: "
        "boards }";
    const std::string mirror = std::string(floor_below) + "reflect: 0.5 }";
    // Maps that squash more than 16 times are the reference kernels'.
    const std::string with_needles =
        "ifs needles { newmap scale: 0.02,0.45,0.02 translate: 0.3,0,0 newmap scale: 0.6 newmap "
        "scale: 0.45 translate: -0.3,0.3,0.2 } object it { ifs: SYSTEM reflect: 0.2 } object them "
        "{ "
        "ifs: needles translate: 0.3,0.3,-0.8 reflect: 0.3 }";
    const std::string lamp = "light lamp { position: 1,2,-1.5 color: 1,1,0.8 shadow: on }";
    return {{"shadows", sun, ""},
            {"shadows_on_a_floor", floor + sun, ""},
            {"a_lamp_that_casts_no_shadow", "light lamp { position: 1,2,-1.5 }", ""},
            {"shadows_of_a_lamp", floor + lamp, ""},
            {"two_lights", floor + sun + lamp, ""},
            {"samples", "", "samples: 4"},
            {"samples_and_shadows", floor + sun, "samples: 3"},
            {"a_texture", wood + sun, ""},
            {"a_mirror", mirror + sun, ""},
            {"two_mirrors", mirror + "plane wall { point: 0,0,1.5 normal: 0,0,-1 reflect: 0.7 }",
             "samples: 2"},
            {"an_object_that_mirrors", floor + sun + "object it { ifs: SYSTEM reflect: 0.4 }", ""},
            {"beside_what_it_cannot_do", floor + lamp + sun + with_needles, "samples: 2"},
            {"behind_what_it_cannot_do", with_needles, ""},
            {"a_crop", floor + sun, "samples: 2"}};
}

class WideTracer : public testing::TestWithParam<std::tuple<std::string, Feature>> {
  protected:
    /// The system with the feature.
    [[nodiscard]] CompiledScene scene() const {
        auto [system, feature] = GetParam();
        const std::string place = "SYSTEM";
        const std::size_t at = feature.text.find(place);
        if (at != std::string::npos) feature.text.replace(at, place.size(), system);
        const bool crop = feature.name == "a_crop";
        return compile_text(
            scene_of(system, feature.render, crop ? "size: 37,29 crop: 3,5,34,27" : "size: 32,24") +
            feature.text);
    }
};

EngineResult run_wide(const CompiledScene& scene, int threads) {
    EngineChoice choice;
    choice.threads = threads;
    return wide::run_wide(scene, choice, {});
}

TEST_P(WideTracer, sees_what_the_clear_kernels_see) {
    const CompiledScene compiled = scene();
    ASSERT_EQ(wide::why_not_wide(compiled, Numeric::single), "");
    EngineChoice clear;
    clear.numeric = Numeric::double_;
    clear.intersect = IntersectMethod::heap;
    const EngineResult expected = run_reference(compiled, clear, {});
    const EngineResult found = run_wide(compiled, 1);
    long different = 0;
    for (std::size_t i = 0; i < found.frame.pixels.size(); ++i) {
        const PixelRecord& a = expected.frame.pixels[i];
        const PixelRecord& b = found.frame.pixels[i];
        float most = std::abs(a.alpha - b.alpha);
        for (int k = 0; k < 3; ++k) most = std::max(most, std::abs(a.color[k] - b.color[k]));
        if (most > 0.004F || a.object != b.object) ++different;
    }
    EXPECT_LE(different, static_cast<long>(found.frame.pixels.size()) / 200);
    // A face along the light is lit or not as it is rounded.
    const auto about = [](std::uint64_t rays) { return static_cast<double>(rays) / 50 + 1; };
    EXPECT_EQ(expected.rays.eye_rays, found.rays.eye_rays);
    EXPECT_NEAR(static_cast<double>(expected.rays.light_rays),
                static_cast<double>(found.rays.light_rays), about(expected.rays.light_rays));
    EXPECT_NEAR(static_cast<double>(expected.rays.reflect_rays),
                static_cast<double>(found.rays.reflect_rays), about(expected.rays.reflect_rays));
}

TEST_P(WideTracer, is_the_same_on_every_kind_of_register_and_for_any_number_of_threads) {
    const CompiledScene compiled = scene();
    const Frame widest = run_wide(compiled, 3).frame;
    for (const int64_t target : {HWY_AVX3, HWY_AVX2, HWY_SSE4, HWY_EMU128}) {
        if ((hwy::SupportedTargets() & target) == 0) continue;
        hwy::SetSupportedTargetsForTest(target);
        const Frame frame = run_wide(compiled, 1).frame;
        hwy::SetSupportedTargetsForTest(0);
        EXPECT_TRUE(same_picture(widest, frame)) << hwy::TargetName(target);
    }
}

std::string name_of(const testing::TestParamInfo<WideTracer::ParamType>& info) {
    return std::get<0>(info.param) + "_" + std::get<1>(info.param).name;
}

INSTANTIATE_TEST_SUITE_P(Features, WideTracer,
                         testing::Combine(testing::Values("tetra", "menger", "elm"),
                                          testing::ValuesIn(features())),
                         name_of);

}  // namespace
}  // namespace pxm::test
