// The wide engine shows an admissible picture (docs/design.md, decision 4): small images of every
// example scene; wide_slow_test.cpp has larger ones. It is judged as a double engine is: what its
// rays share is kept in double, so p has the floor of double.
#include <gtest/gtest.h>

#include <hwy/targets.h>

#include "host/wide/wide_engine.hpp"
#include "host/wide/wide_scene.hpp"
#include "tests/support/compile_text.hpp"
#include "tests/support/example_scenes.hpp"
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
    const Verdict verdict = judge(scene_, render_wide(scene_), Numeric::twice);
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

std::string name_of(const testing::TestParamInfo<Example>& example) { return example.param.name; }

INSTANTIATE_TEST_SUITE_P(Examples, Wide, testing::ValuesIn(example_scenes("20,15")), name_of);

}  // namespace
}  // namespace pxm::test
