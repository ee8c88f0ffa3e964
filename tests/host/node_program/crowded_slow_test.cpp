// As crowded_test.cpp: pictures of cells that overlap nearly, against searches for every word, and
// how many cells they open.
#include <gtest/gtest.h>

#include <cmath>

#include "host/node_program/crowded.hpp"
#include "tests/support/compile_text.hpp"
#include "tests/support/crowds.hpp"
#include "tests/support/example_scenes.hpp"

namespace pxm::test {
namespace {

using namespace host;

class NearlyTheSame : public testing::TestWithParam<Example> {};

/// Design decision 4: a terminal cell is shown, and none lies more than a pixel nearer.
TEST_P(NearlyTheSame, cells_opened_once_give_an_admissible_picture) {
    const CompiledScene scene = compile_text(GetParam().text);
    const std::vector<SeenPixel> known = look_at(scene, known_share(scene));
    const std::vector<SeenPixel> every_word = look_at(scene, 0);
    long hits = 0;
    for (std::size_t i = 0; i < known.size(); ++i) {
        ASSERT_NE(every_word[i].outcome, kernels::Outcome::capped);
        ASSERT_EQ(known[i].outcome, every_word[i].outcome) << "pixel " << i;
        if (every_word[i].outcome == kernels::Outcome::miss) continue;
        ++hits;
        const double key = every_word[i].key;
        const double p = scene.camera.pixel_at_eye + scene.camera.pixel_growth * key;
        ASSERT_LE(known[i].key, key + p) << "pixel " << i;
        ASSERT_GE(known[i].key, key) << "pixel " << i;
    }
    EXPECT_GT(hits, 30);
}

std::string name_of(const testing::TestParamInfo<Example>& example) { return example.param.name; }

INSTANTIATE_TEST_SUITE_P(Crowds, NearlyTheSame,
                         testing::Values(Example{"fat_square", fat_square(7)},
                                         Example{"fat_cube", fat_cube(40)}),
                         name_of);

/// Counted, not timed: every word that leads to a cell would be a million of them for each ray.
TEST(CrowdedSlow, no_ray_is_given_up_and_few_cells_are_opened) {
    const EngineResult fat = render_natively(compile_text(fat_square(40)), Numeric::single, 2);
    EXPECT_EQ(fat.rays.capped_rays, 0U);
    EXPECT_EQ(fat.rays.hits, 34U * 34U);
    EXPECT_LT(fat.rays.volumes_tested, 12'000U * 1600U);
    const EngineResult same =
        render_natively(compile_text(square_of_coinciding_cells(100)), Numeric::single, 2);
    EXPECT_EQ(same.rays.capped_rays, 0U);
    EXPECT_GT(same.rays.hits, 6900U);
    EXPECT_LT(same.rays.volumes_tested, 3'000U * 10'000U);
}

}  // namespace
}  // namespace pxm::test
