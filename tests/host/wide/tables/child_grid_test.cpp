// Which systems are grids, and that the walk through one sees what the children in lanes see.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "host/wide/tables/eligible.hpp"
#include "host/wide/tile/wide_engine.hpp"
#include "tests/support/compile_text.hpp"
#include "tests/support/example_scenes.hpp"
#include "tests/support/referee.hpp"

namespace pxm::test {
namespace {

using namespace host;

std::string method_of(const std::string& text) {
    return wide::object_methods(compile_text(text)).front().method;
}

/// Boxes at the places of a 3x3x3 grid that `is_in` names; at a ratio of 1/3 they touch.
template <class IsIn>
std::string thirds(double ratio, const IsIn& is_in) {
    std::string text = "ifs it {\n";
    for (int place = 0; place < 27; ++place) {
        const int x = place % 3 - 1, y = place / 3 % 3 - 1, z = place / 9 - 1;
        if (!is_in(x, y, z)) continue;
        text += fmt::format("newmap scale: {} translate: {},{},{}\n", ratio, x, y, z);
    }
    return text + "}\nobject it { ifs: it }\nimage { size: 24,18 }\nrender { volume: box }\n";
}
bool sponge(int x, int y, int z) { return (x == 0) + (y == 0) + (z == 0) < 2; }
bool corners(int x, int y, int z) { return x != 0 && y != 0 && z != 0; }
bool cross(int x, int y, int z) { return x * x + y * y + z * z == 1; }

TEST(ChildGrid, is_found_where_boxes_are_in_slices) {
    EXPECT_EQ(method_of(thirds(1.0 / 3, sponge)), "wide, grid walk");
    EXPECT_EQ(method_of(thirds(0.31, sponge)), "wide, grid walk");  // gaps between the slices
    EXPECT_EQ(method_of(thirds(1.0 / 3, corners)), "wide, grid walk");
    EXPECT_EQ(method_of(thirds(1.0 / 3, cross)), "wide, grid walk");
}

/// A ray keeps at most 64 cells that it has met; one that walks keeps none.
TEST(ChildGrid, may_have_more_children_than_a_ray_keeps) {
    std::string text = "ifs it {\n";
    for (int place = 0; place < 125; ++place) {
        const int x = place % 5 - 2, y = place / 5 % 5 - 2, z = place / 25 - 2;
        if ((x == 0) + (y == 0) + (z == 0) >= 2) continue;
        text += fmt::format("newmap scale: 0.2 translate: {},{},{}\n", x, y, z);
    }
    text += "}\nobject it { ifs: it }\nimage { size: 24,18 }\n";
    const CompiledScene boxes = compile_text(text + "render { volume: box }\n");
    EXPECT_EQ(wide::object_methods(boxes).front().method, "wide, grid walk");
    const CompiledScene balls = compile_text(text + "render { volume: sphere }\n");
    EXPECT_EQ(wide::object_methods(balls).front().because, "very many maps");
    for (const CompiledScene* scene : {&boxes, &balls}) {
        const Verdict verdict =
            judge(*scene, wide::run_wide(*scene, {}, {}).frame, Numeric::double_);
        EXPECT_GE(verdict.admissible_share(), 0.999) << verdict.report;
        EXPECT_EQ(verdict.wrong_colors, 0) << verdict.report;
    }
}

TEST(ChildGrid, is_not_where_slices_overlap_or_cells_are_balls) {
    EXPECT_NE(method_of(thirds(0.36, sponge)), "wide, grid walk");
    EXPECT_NE(method_of(scene_of("menger", "volume: sphere")), "wide, grid walk");
    EXPECT_NE(method_of(scene_of("octo", "volume: box")), "wide, grid walk");
}

TEST(GridWalk, shows_the_nearest_terminal_cells) {
    for (const double ratio : {1.0 / 3, 0.31}) {
        for (const auto& is_in : {sponge, corners, cross}) {
            for (const char* view :
                 {"camera { eye: 1.8,2.9,-6 look: 0,0,0 fov: 40 }",
                  "camera { eye: 0.013,0.029,-6 look: 0,0,0 fov: 40 }",        // along the slices
                  "camera { eye: 0.85,0.2,0.05 look: -1,-0.2,-0.1 fov: 80 }",  // from inside
                  "camera { eye: -4,3,1.5 look: 0,0,0 orthographic: 3 }"}) {
                const CompiledScene scene = compile_text(thirds(ratio, is_in) + view);
                const Verdict verdict =
                    judge(scene, wide::run_wide(scene, {}, {}).frame, Numeric::double_);
                EXPECT_GE(verdict.admissible_share(), 0.999) << view << verdict.report;
                EXPECT_EQ(verdict.wrong_colors, 0) << view << verdict.report;
            }
        }
    }
}

}  // namespace
}  // namespace pxm::test
