// Rays that walk through slices side by side, in the lanes of a register, see to the last bit what
// each sees that walks alone (host/wide/search/grid_walk.inl).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <hwy/targets.h>

#include <functional>
#include <random>

#include "host/node_program/write_scene_block.hpp"
#include "host/wide/tables/wide_scene.hpp"
#include "host/wide/tile/tile_tracer.hpp"
#include "tests/support/compile_text.hpp"
#include "tests/support/render_text.hpp"

namespace pxm::test {
namespace {

using namespace host;

enum class Walk { alone, in_lanes };

/// The whole picture, and what its rays added up to.
struct Picture {
    Frame frame;
    RayStatistics rays;
};

Picture picture_of(const CompiledScene& scene, Walk walk) {
    wide::WideScene tables = wide::make_wide_scene(scene);
    if (walk == Walk::alone) {
        for (wide::WideObject& object : tables.objects) object.common_grid = -1;
    }
    const wide::ReferenceFallback rest(scene, tables);
    const auto block = make_scene_block<double>(scene);
    wide::TileTracer tracer(scene, tables, rest, block);
    Picture picture{Frame(scene.size, scene.crop), {}};
    for (long top = 0; top < picture.frame.rows(); top += tile_side) {
        for (long left = 0; left < picture.frame.columns(); left += tile_side) {
            tracer.render(picture.frame, left, top, [] { return true; });
        }
    }
    picture.rays = tracer.finish();
    return picture;
}

/// Whether an object of the scene has a grid that serves all its cells.
bool has_common_grid(const CompiledScene& scene) {
    const wide::WideScene tables = wide::make_wide_scene(scene);
    return tables.objects.front().common_grid >= 0;
}

void expect_same(const CompiledScene& scene, const std::string& what) {
    ASSERT_TRUE(has_common_grid(scene)) << what;
    const Picture alone = picture_of(scene, Walk::alone);
    const Picture in_lanes = picture_of(scene, Walk::in_lanes);
    ASSERT_GT(alone.rays.hits, 0U) << what;
    EXPECT_TRUE(same_picture(alone.frame, in_lanes.frame)) << what;
    EXPECT_EQ(alone.rays.volumes_tested, in_lanes.rays.volumes_tested) << what;
}

struct Slices {
    int x, y, z;
    double ratio;  // of a map; slices are as far apart as fit into the cube
};
/// Whether a place holds a child.
using IsIn = std::function<bool(int x, int y, int z)>;

/// The maps to the places of a grid, one a line.
std::string maps_of(const Slices& slices, const IsIn& is_in) {
    const auto place = [&](int i, int n) { return n == 1 ? 0 : (2.0 * i / (n - 1) - 1); };
    std::string text;
    for (int z = 0; z < slices.z; ++z) {
        for (int y = 0; y < slices.y; ++y) {
            for (int x = 0; x < slices.x; ++x) {
                if (!is_in(x, y, z)) continue;
                text += fmt::format("newmap m{}{}{} scale: {} translate: {},{},{}\n", x, y, z,
                                    slices.ratio, place(x, slices.x), place(y, slices.y),
                                    place(z, slices.z));
            }
        }
    }
    return text;
}

std::string scene_of_maps(const std::string& maps, const std::string& view) {
    return "ifs it {\n" + maps + "}\nobject it { ifs: it }\nimage { size: 44,36 }\n" +
           "render { volume: box }\n" + view;
}

const char* const views[] = {
    "camera { eye: 1.8,2.9,-6 look: 0,0,0 fov: 40 }",
    "camera { eye: 0.013,0.029,-6 look: 0,0,0 fov: 40 }",        // along the slices
    "camera { eye: -4,-3,2.5 look: 0.3,0,0 fov: 12 }",           // large
    "camera { eye: 0.85,0.2,0.05 look: -1,-0.2,-0.1 fov: 80 }",  // from inside
    "camera { eye: -4,3,1.5 look: 0,0,0 orthographic: 3 }",      // cells of a level end together
    "camera { eye: 4,4,4 look: 0,0,0 orthographic: 3 }",         // rays that meet edges
    "camera { eye: 1.8,2.9,-6 look: 0,0,0 fov: 40 } light { direction: 0.5,1,-0.7 shadow: on }"};

bool corner(const Slices& slices, int x, int y, int z) {
    return x % (slices.x - 1) == 0 && y % (slices.y - 1) == 0 && z % (slices.z - 1) == 0;
}

TEST(GridLanes, see_what_single_rays_see) {
    const IsIn sponge = [](int x, int y, int z) { return (x == 1) + (y == 1) + (z == 1) < 2; };
    for (const double ratio : {1.0 / 3, 0.31}) {
        for (const char* view : views) {
            const std::string text = scene_of_maps(maps_of({3, 3, 3, ratio}, sponge), view);
            expect_same(compile_text(text), text);
        }
    }
}

TEST(GridLanes, may_go_through_other_numbers_of_slices) {
    std::mt19937 engine(5);
    for (const Slices& slices : {Slices{2, 2, 2, 0.45}, Slices{2, 3, 4, 0.25}, Slices{4, 4, 2, 0.2},
                                 Slices{8, 2, 2, 0.12}, Slices{2, 5, 3, 0.2}}) {
        for (const char* view : views) {
            const IsIn some = [&](int x, int y, int z) {
                return corner(slices, x, y, z) || engine() % 2 == 0;
            };
            const std::string text = scene_of_maps(maps_of(slices, some), view);
            expect_same(compile_text(text), text);
        }
    }
}

/// After each map some of the places are left out.
TEST(GridLanes, may_go_through_a_graph) {
    const Slices slices{3, 3, 3, 1.0 / 3};
    std::mt19937 engine(7);
    for (const char* view : views) {
        std::string rules;
        const auto name = [](int i) { return fmt::format("m{}{}{}", i % 3, i / 3 % 3, i / 9); };
        for (int map = 0; map < 27; ++map) {
            rules += fmt::format("follow: {} -> ", name(map));
            std::string after;
            for (int next = 0; next < 27; ++next) {
                if (!corner(slices, next % 3, next / 3 % 3, next / 9) && engine() % 2 == 0)
                    continue;
                after += (after.empty() ? "" : ", ") + name(next);
            }
            rules += after + "\n";
        }
        const IsIn all = [](int, int, int) { return true; };
        const std::string text = scene_of_maps(maps_of(slices, all) + rules, view);
        const CompiledScene scene = compile_text(text);
        ASSERT_TRUE(has_common_grid(scene)) << text;
        ASSERT_GT(wide::make_wide_scene(scene).common_grids.front().sets.size(), 5U);
        expect_same(scene, text);
    }
}

/// Rays that test too many cells are left to the reference kernels, the same ones.
TEST(GridLanes, give_up_where_single_rays_do) {
    const IsIn sponge = [](int x, int y, int z) { return (x == 1) + (y == 1) + (z == 1) < 2; };
    for (const std::uint32_t cap : {3U, 6U, 9U}) {
        CompiledScene scene =
            compile_text(scene_of_maps(maps_of({3, 3, 3, 0.31}, sponge), views[0]));
        scene.cell_cap = cap;
        expect_same(scene, fmt::format("{} cells", cap));
    }
}

TEST(GridLanes, see_the_same_on_every_kind_of_register) {
    const IsIn sponge = [](int x, int y, int z) { return (x == 1) + (y == 1) + (z == 1) < 2; };
    for (const char* view : views) {
        const CompiledScene scene =
            compile_text(scene_of_maps(maps_of({3, 3, 3, 0.31}, sponge), view));
        const Frame widest = picture_of(scene, Walk::in_lanes).frame;
        for (const int64_t target : {HWY_AVX3, HWY_AVX2, HWY_SSE4, HWY_EMU128}) {
            if ((hwy::SupportedTargets() & target) == 0) continue;
            hwy::SetSupportedTargetsForTest(target);
            const Frame frame = picture_of(scene, Walk::in_lanes).frame;
            hwy::SetSupportedTargetsForTest(0);
            EXPECT_TRUE(same_picture(widest, frame)) << hwy::TargetName(target) << view;
        }
    }
}

}  // namespace
}  // namespace pxm::test
