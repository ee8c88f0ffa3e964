// Systems of homotheties, of which the wide engine knows a cell by its centre and its size.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <random>

#include "host/wide/tile/wide_engine.hpp"
#include "tests/support/compile_text.hpp"
#include "tests/support/referee.hpp"

namespace pxm::test {
namespace {

using namespace host;

/// Homotheties of any number and any ratios, that overlap or leave gaps.
TEST(WideHomotheties, of_random_systems_show_admissible_cells) {
    std::mt19937 engine(11);
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine);
    };
    const auto direction = [&] {
        return glm::normalize(glm::dvec3{between(-1, 1), between(-1, 1), between(-1, 1)});
    };
    for (int system = 0; system < 24; ++system) {
        std::string text = "ifs it {\n";
        const int maps = 2 + system % 12;
        for (int map = 0; map < maps; ++map) {
            const glm::dvec3 place = direction();
            text += fmt::format("newmap scale: {} translate: {},{},{}\n", between(0.2, 0.6),
                                place.x, place.y, place.z);
        }
        text += "}\nobject it { ifs: it }\nimage { size: 40,30 }\n";
        text += fmt::format("render {{ volume: {} }}\n", system % 3 == 0 ? "box" : "sphere");
        const glm::dvec3 eye = 6.0 * direction();
        text +=
            fmt::format("camera {{ eye: {},{},{} look: 0,0,0 fov: 35 }}\n", eye.x, eye.y, eye.z);
        const CompiledScene scene = compile_text(text);
        const Verdict verdict = judge(scene, wide::run_wide(scene, {}, {}).frame, Numeric::double_);
        EXPECT_GE(verdict.admissible_share(), 0.999) << text << verdict.report;
        EXPECT_EQ(verdict.wrong_colors, 0) << text << verdict.report;
    }
}

}  // namespace
}  // namespace pxm::test
