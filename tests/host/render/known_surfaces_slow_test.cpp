// Known surfaces and solids from all sides, in all kinds of volumes, by all engines: no ray is lost
// in the faces between their cells, and none ends farther from them than a cell reaches.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "host/render/native_numeric.hpp"
#include "host/render/render.hpp"
#include "host/wide/tables/eligible.hpp"
#include "host/wide/tile/wide_engine.hpp"
#include "tests/support/compile_text.hpp"
#include "tests/support/known_view.hpp"

namespace pxm::test {
namespace {

using namespace host;

constexpr int side = 48;  // of the pictures, in pixels; known_views() counts on it

bool is_wide(const CompiledScene& scene) {
    return wide::why_not_wide(scene, Numeric::single).empty();
}

/// As `pxm render` does it.
Frame rendered(const CompiledScene& scene) {
    EngineChoice choice;
    choice.numeric = native_numeric(scene);
    choice.intersect = is_wide(scene) ? IntersectMethod::wide : IntersectMethod::heap;
    return load(scene, choice)->run(scene.crop, {}).frame;
}

class KnownSurfacesFromAllSides : public testing::TestWithParam<KnownSurface> {
  protected:
    [[nodiscard]] CompiledScene compiled(const KnownView& view, const std::string& render) const {
        return compile_text(text_of(GetParam(), view, side, render), 1, NearCells::kept);
    }
    void expect_whole(const KnownView& view, const CompiledScene& scene, const Frame& frame,
                      const std::string& how) const {
        const SurfaceVerdict verdict = judge(GetParam(), view, scene, frame);
        EXPECT_EQ(verdict.lost, 0) << how << '\n' << verdict.report;
        EXPECT_EQ(verdict.beside, 0) << how << '\n' << verdict.report;
    }
};

TEST_P(KnownSurfacesFromAllSides, have_no_cracks_in_any_volume_with_flat_faces) {
    for (const KnownView& view : known_views()) {
        for (const char* volume : {"auto", "box", "oriented", "hull"}) {
            const CompiledScene scene = compiled(view, std::string("volume: ") + volume);
            expect_whole(view, scene, rendered(scene), fmt::format("by default, {}", volume));
            expect_whole(view, scene, render_natively(scene, Numeric::double_).frame,
                         fmt::format("heap in double, {}", volume));
        }
    }
}

/// In the numbers of the machine too, and on it; in dsp32 but for rays by design in the faces of
/// boxes along the axes, which are aimed at the middle of a pixel as ever.
TEST_P(KnownSurfacesFromAllSides, have_no_cracks_in_float) {
    for (const KnownView& view : known_views()) {
        for (const std::string volume : {"auto", "box", "oriented", "hull"}) {
            const CompiledScene scene = compiled(view, "volume: " + volume);
            expect_whole(view, scene, render_natively(scene, Numeric::single).frame,
                         "float, " + volume);
            if (volume == "box" && !view.general) continue;
            expect_whole(view, scene, render_on("964dX", scene, Numeric::dsp32).frame,
                         "dsp32, " + volume);
        }
    }
}

/// In double: where balls only touch, at the corners of tiles, floats lose rays through them.
TEST_P(KnownSurfacesFromAllSides, have_no_cracks_in_balls) {
    for (const KnownView& view : known_views()) {
        const CompiledScene scene = compiled(view, "volume: sphere");
        expect_whole(view, scene, render_natively(scene, Numeric::double_).frame, "balls");
    }
}

/// All that is inside is opaque by area: in perspective the rays through the places of a pixel
/// part, and cells that touch are not equally deep. In balls too, though what a set covers of a
/// ball is less than the ball: inside, its neighbours have the rest.
TEST_P(KnownSurfacesFromAllSides, are_opaque_by_area) {
    for (const KnownView& view : known_views()) {
        if (view.fov == 0 && !view.general) continue;
        for (const char* volume : {"auto", "sphere"}) {
            const CompiledScene scene =
                compiled(view, std::string("covers: area volume: ") + volume);
            const SurfaceVerdict verdict = judge(GetParam(), view, scene, rendered(scene));
            EXPECT_EQ(verdict.thin, 0)
                << view.name << " in " << volume << ": least " << verdict.least_alpha;
        }
    }
}

/// Normals of flat faces are exact but for rays that come in by the rim of a thin volume, and those
/// of curved ones near enough. Seen along faces, whole columns come in by the largest cells' rims.
TEST_P(KnownSurfacesFromAllSides, are_turned_as_they_are) {
    for (const KnownView& view : known_views()) {
        const CompiledScene scene = compiled(view, "");
        const SurfaceVerdict verdict =
            judge(GetParam(), view, scene, rendered(scene), GetParam().is_curved() ? 25 : 1);
        EXPECT_LE((view.general ? 50 : 12) * verdict.turned, verdict.flat) << verdict.report;
    }
}

INSTANTIATE_TEST_SUITE_P(All, KnownSurfacesFromAllSides, testing::ValuesIn(known_surfaces()),
                         [](const auto& one) { return one.param.name; });

}  // namespace
}  // namespace pxm::test
