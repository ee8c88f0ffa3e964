// Local covers by area in the wide engine (host/wide/area/area_search.hpp): what the reference
// kernels show in double. Where all rays of a tile are parallel the two do the same sums, and the
// pictures are the same but for ties. In perspective the cells of a pixel are put in the order in
// which they lie from the eye, not in that of their depths along the pixel's first ray.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <hwy/targets.h>

#include <algorithm>
#include <cmath>

#include "host/wide/tables/eligible.hpp"
#include "host/wide/tile/wide_engine.hpp"
#include "tests/support/compile_text.hpp"
#include "tests/support/example_scenes.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/render_text.hpp"

namespace pxm::test {
namespace {

using namespace host;

/// A scene with a heap that nothing overflows: the wide engine has none.
CompiledScene compile_roomy(const std::string& text, double zoom = 1) {
    CompiledScene scene = compile_text(text, zoom);
    scene.heap = 1 << 15;
    return scene;
}

CompiledScene area_scene(const std::string& system, const std::string& render = "",
                         const std::string& more = "", const std::string& image = "size: 30,24") {
    return compile_roomy(scene_of(system, "covers: area " + render, image) + more);
}

EngineResult run_wide(const CompiledScene& scene, int threads = 1) {
    EngineChoice choice;
    choice.threads = threads;
    return wide::run_wide(scene, choice, {});
}

EngineResult run_clear(const CompiledScene& scene) {
    EngineChoice choice;
    choice.numeric = Numeric::double_;
    choice.intersect = IntersectMethod::heap;
    return run_reference(scene, choice, {});
}

/// How far two pictures are from each other: of a pixel the channel that differs most.
struct Difference {
    double pixels = 0;
    double hits = 0;     // of the first picture
    double seen = 0;     // pixels that differ by more than 1/255
    double clear = 0;    // by more than 0.02
    double objects = 0;  // that show another object
    double rms = 0;
};

Difference difference(const Frame& a, const Frame& b) {
    Difference sum;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const PixelRecord& p = a.pixels[i];
        const PixelRecord& q = b.pixels[i];
        double most = std::abs(static_cast<double>(p.alpha - q.alpha));
        for (int k = 0; k < 3; ++k) {
            most = std::max(most, static_cast<double>(std::abs(p.color[k] - q.color[k])));
        }
        sum.pixels += 1;
        sum.hits += p.object >= 0 ? 1 : 0;
        sum.seen += most > 0.004 ? 1 : 0;
        sum.clear += most > 0.02 ? 1 : 0;
        sum.objects += p.object != q.object ? 1 : 0;
        sum.rms += most * most;
    }
    sum.rms = std::sqrt(sum.rms / sum.pixels);
    return sum;
}

Difference difference(const CompiledScene& scene) {
    EXPECT_EQ(wide::why_not_wide(scene, Numeric::single), "");
    return difference(run_clear(scene).frame, run_wide(scene).frame);
}

struct Case {
    std::string name;
    std::string system;
    std::string render;
    std::string more;
};
void PrintTo(const Case& one, std::ostream* out) { *out << one.name; }
std::string name_of(const testing::TestParamInfo<Case>& one) { return one.param.name; }

constexpr const char* parallel = "camera { eye: 1.1,1.7,-5 look: 0.03,0.21,0 orthographic: 2.7 }";
constexpr const char* sun = "light sun { direction: -0.5,1,-0.7 shadow: on }";
constexpr const char* lamp = "light lamp { position: 1,2,-1.5 color: 1,1,0.8 shadow: on }";
constexpr const char* fill = "light fill { position: -2,1,-3 color: 0.3,0.4,0.5 }";
constexpr const char* boards =
    "texture boards { wood size: 0.5,0.1 } "
    "plane floor { point: 0,-0.6,0 normal: 0,1,0 texture: boards reflect: 0.3 }";

std::vector<Case> cases() {
    std::vector<Case> all;
    for (const char* volume : {"sphere", "box", "oriented"}) {
        for (const char* system :
             {"tetra", "menger", "asymmetric", "hierarchical", "squashed", "mirrored"}) {
            all.push_back({fmt::format("{}_{}", system, volume), system,
                           fmt::format("volume: {}", volume), ""});
        }
    }
    for (const char* lipschitz : {"product", "determinant", "polar"}) {
        all.push_back({std::string("squashed_") + lipschitz, "squashed",
                       std::string("shading: low-pass lipschitz: ") + lipschitz, ""});
    }
    all.push_back({"elm", "elm", "", ""});
    all.push_back({"bulging", "bulging", "", ""});
    all.push_back({"large_cells", "elm", "detail: 6 volume: box shading: high-pass", ""});
    all.push_back({"one_place", "octo", "samples: 1", ""});
    all.push_back({"many_places", "icos", "samples: 32 shading: facet", ""});
    all.push_back({"levels", "menger", "", "object it { ifs: menger levels: 1 }"});
    all.push_back({"shadows", "tetra", "", std::string(sun) + lamp + fill});
    all.push_back({"floor", "menger", "", std::string(boards) + sun});
    all.push_back(
        {"mirror", "elm", "", std::string(boards) + fill + "object it { ifs: elm reflect: 0.4 }"});
    all.push_back({"two_objects", "tetra", "",
                   ifs("elm") + "object it { ifs: tetra } object tree { ifs: elm scale: 0.7 "
                                "translate: 0.2,-0.3,-0.3 color: 0.2,0.9,0.3,1 }"});
    return all;
}

class Beams : public testing::TestWithParam<Case> {
  protected:
    [[nodiscard]] CompiledScene scene(const std::string& camera, const std::string& image) const {
        const Case& one = GetParam();
        return area_scene(one.system, one.render, one.more + camera, image);
    }
};

TEST_P(Beams, that_are_parallel_show_what_the_clear_kernels_show) {
    const Difference found = difference(scene(parallel, "size: 30,24"));
    EXPECT_GT(found.hits, 0.05 * found.pixels);
    // A mirror, a shadow's edge and a tie of two cells are as they are rounded.
    EXPECT_LE(found.seen, 0.004 * found.pixels);
    EXPECT_LE(found.clear, 0.002 * found.pixels);
    EXPECT_LE(found.objects, 1);
}

TEST_P(Beams, are_the_same_on_every_kind_of_register_and_for_any_number_of_threads) {
    const CompiledScene compiled = scene("", "size: 20,19 crop: 3,2,19,15");
    const Frame widest = run_wide(compiled, 3).frame;
    for (const int64_t target : {HWY_AVX3, HWY_AVX2, HWY_SSE4, HWY_EMU128}) {
        if ((hwy::SupportedTargets() & target) == 0) continue;
        hwy::SetSupportedTargetsForTest(target);
        const Frame frame = run_wide(compiled).frame;
        hwy::SetSupportedTargetsForTest(0);
        EXPECT_TRUE(same_picture(widest, frame)) << hwy::TargetName(target);
    }
}

INSTANTIATE_TEST_SUITE_P(Cases, Beams, testing::ValuesIn(cases()), name_of);

class BeamsInPerspective : public Beams {};

TEST_P(BeamsInPerspective, show_nearly_what_the_clear_kernels_show) {
    const Difference found = difference(scene("", "size: 48,36"));
    EXPECT_GT(found.hits, 0.05 * found.pixels);
    EXPECT_LE(found.seen, 0.06 * found.pixels);
    EXPECT_LE(found.clear, 0.02 * found.pixels);
    EXPECT_LE(found.rms, 0.007);
    EXPECT_LE(found.objects, 0.004 * found.pixels);
}

std::vector<Case> cases_in_perspective() {
    std::vector<Case> some = cases();
    std::erase_if(some, [](const Case& one) {
        constexpr const char* names[] = {"tetra_sphere", "menger_box",  "asymmetric_oriented",
                                         "elm",          "large_cells", "many_places",
                                         "shadows",      "mirror"};
        return std::ranges::find(names, one.name) == std::end(names);
    });
    return some;
}
INSTANTIATE_TEST_SUITE_P(Cases, BeamsInPerspective, testing::ValuesIn(cases_in_perspective()),
                         name_of);

/// What a picture says besides its colours is of the cell with the largest share.
TEST(BeamRecords, are_those_of_the_clear_kernels) {
    const CompiledScene scene = area_scene("menger", "", parallel);
    const EngineResult expected = run_clear(scene);
    const EngineResult found = run_wide(scene);
    for (std::size_t i = 0; i < found.frame.pixels.size(); ++i) {
        const PixelRecord& a = expected.frame.pixels[i];
        const PixelRecord& b = found.frame.pixels[i];
        ASSERT_EQ(a.word, b.word) << i;
        ASSERT_EQ(a.level, b.level) << i;
        if (a.object < 0) continue;
        ASSERT_NEAR(a.z, b.z, 1e-5F * a.z) << i;
        ASSERT_NEAR(a.normal[1], b.normal[1], 1e-5F) << i;
    }
    EXPECT_EQ(expected.rays.eye_rays, found.rays.eye_rays);
    EXPECT_EQ(expected.rays.hits, found.rays.hits);
}

/// A cell that is much wider than a tile is seen far from its centre, where it may be nearer than
/// its key.
TEST(BeamOrder, of_large_cells_is_that_of_their_nearest_points) {
    const CompiledScene scene =
        compile_roomy("include: \"" + test::source_dir +
                      "/scenes/menger.pxm\" render { covers: area } "
                      "image { size: 640,480 crop: 400,280,440,304 } "
                      "camera { eye: 0.6,0.9,-1.5 look: 0.355432,0.488553,0.222312 fov: 40 }");
    const Difference found = difference(scene);
    EXPECT_GT(found.hits, 0.5 * found.pixels);
    EXPECT_LE(found.clear, 0.005 * found.pixels);
}

TEST(BeamZoom, is_right_at_any_magnification) {
    const std::string camera = "camera { eye: 0.6,0.9,-1.5 look: 0.36,0.49,0.22 fov: 40 }";
    const CompiledScene scene =
        compile_roomy(scene_of("menger", "covers: area", "size: 36,28") + camera, 1e6);
    const Difference found = difference(scene);
    EXPECT_GT(found.hits, 0.1 * found.pixels);
    EXPECT_LE(found.clear, 0.01 * found.pixels);
}

/// Cells around the eye are the reference kernels' still, and all tiles that see them.
TEST(BeamInside, leaves_what_is_around_the_eye) {
    const CompiledScene scene = compile_roomy(
        scene_of("menger", "covers: area", "size: 24,18") +
        "object it { ifs: menger levels: 0 } camera { eye: 0.1,0.1,0.2 look: 0.3,0,1 fov: 60 }");
    EXPECT_EQ(difference(scene).seen, 0);
}

TEST(BeamChoice, is_told) {
    const auto methods = wide::object_methods(compile_text(scene_of("octo", "covers: area")));
    ASSERT_EQ(methods.size(), 1U);
    EXPECT_EQ(methods[0].method, "wide, beams");
    EXPECT_EQ(methods[0].because, "local covers by area");
}

TEST(BeamChoice, says_why_not) {
    const auto reason = [](const std::string& text) {
        return wide::why_not_wide(compile_text(text), Numeric::single);
    };
    EXPECT_EQ(reason(scene_of("elm", "covers: area")), "");
    EXPECT_EQ(reason(scene_of("elm", "covers: on")),
              "local covers by diameter and translucent objects are the reference kernels'");
    EXPECT_EQ(reason(scene_of("tetra", "covers: area volume: hull")),
              "object \"tetra\" has bounding volumes that are neither balls nor boxes, and local "
              "covers by area are done by one engine");
}

}  // namespace
}  // namespace pxm::test
