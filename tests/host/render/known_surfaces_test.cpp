// Surfaces and solids that are known exactly (tests/support/known_surface): no ray is lost in the
// faces between their cells, and with the volumes that `auto` takes their pictures show how they
// are turned. known_surfaces_slow_test.cpp has all views, volumes and engines.
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

constexpr int side = 24;  // of the pictures, in pixels

KnownView view(const std::string& name) {
    for (const KnownView& one : known_views()) {
        if (one.name == name) return one;
    }
    throw std::runtime_error("no view of that name: " + name);
}

CompiledScene scene_of(const KnownSurface& surface, const KnownView& seen,
                       const std::string& render) {
    return compile_text(text_of(surface, seen, side, render), 1, NearCells::kept);
}

class KnownSurfaces : public testing::TestWithParam<KnownSurface> {};

TEST_P(KnownSurfaces, are_seen_where_they_are_and_turned_as_they_are) {
    const double most_degrees = GetParam().is_curved() ? 20 : 1;
    for (const char* name : {"along_z", "from_somewhere", "near"}) {
        const CompiledScene scene = scene_of(GetParam(), view(name), "");
        EngineChoice choice;
        const bool wide = wide::why_not_wide(scene, Numeric::single).empty();
        choice.intersect = wide ? IntersectMethod::wide : IntersectMethod::heap;
        const SurfaceVerdict verdict =
            judge(GetParam(), view(name), scene, load(scene, choice)->run(scene.crop, {}).frame,
                  most_degrees);
        EXPECT_GT(verdict.rays, 50);
        EXPECT_EQ(verdict.lost, 0) << verdict.report;
        EXPECT_EQ(verdict.beside, 0) << verdict.report;
        EXPECT_LE(50 * verdict.turned, verdict.flat) << verdict.report;
    }
}

/// The wide engine is what renders boxes by default. Its grids, its composed maps, and boxes in
/// axes of their own have a test of a cell each.
TEST(KnownSurfacesInBoxes, lose_no_ray_in_the_faces_between_them) {
    for (const char* name : {"slope", "saddle", "cube", "cube_of_fifths", "prism"}) {
        const KnownSurface surface = known_surface(name);
        for (const char* volume : {"box", "oriented"}) {
            for (const char* from : {"along_z", "turned"}) {
                const KnownView seen = view(from);
                const CompiledScene scene =
                    scene_of(surface, seen, std::string("volume: ") + volume);
                ASSERT_EQ(wide::why_not_wide(scene, Numeric::single), "");
                const SurfaceVerdict verdict =
                    judge(surface, seen, scene, wide::run_wide(scene, {}, {}).frame);
                EXPECT_GT(verdict.rays, 100);
                EXPECT_EQ(verdict.lost, 0) << volume << ' ' << verdict.report;
            }
        }
    }
}

/// In perspective the rays through the places of a pixel part: no place is lost where cells touch
/// that are not equally deep.
TEST_P(KnownSurfaces, are_opaque_by_area) {
    for (const char* name : {"near", "near_somewhere"}) {
        const CompiledScene scene = scene_of(GetParam(), view(name), "covers: area");
        EngineChoice choice;
        const bool wide = wide::why_not_wide(scene, Numeric::single).empty();
        choice.intersect = wide ? IntersectMethod::wide : IntersectMethod::heap;
        choice.numeric = native_numeric(scene);
        const SurfaceVerdict verdict =
            judge(GetParam(), view(name), scene, load(scene, choice)->run(scene.crop, {}).frame);
        EXPECT_GT(verdict.flat, 4) << name;
        EXPECT_EQ(verdict.thin, 0) << name << ' ' << verdict.least_alpha;
    }
}

INSTANTIATE_TEST_SUITE_P(All, KnownSurfaces, testing::ValuesIn(known_surfaces()),
                         [](const auto& one) { return one.param.name; });

}  // namespace
}  // namespace pxm::test
