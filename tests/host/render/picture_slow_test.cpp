// The laws of picture_test.cpp on images with more pixels, and for the numbers of the machine.
#include <gtest/gtest.h>

#include "tests/support/compile_text.hpp"
#include "tests/support/example_scenes.hpp"
#include "tests/support/referee.hpp"

namespace pxm::test {
namespace {

using namespace host;

class LargerPicture : public testing::TestWithParam<Example> {};

TEST_P(LargerPicture, is_the_oracles_in_double_and_admissible_in_float_and_dsp32) {
    const CompiledScene scene = compile_text(GetParam().text);
    const Verdict twice =
        judge(scene, render_natively(scene, Numeric::double_).frame, Numeric::double_);
    EXPECT_GE(twice.same_share(), 0.999) << twice.report;
    EXPECT_GE(twice.admissible_share(), 0.999) << twice.report;
    EXPECT_EQ(twice.wrong_colors, 0) << twice.report;
    for (const Numeric numeric : {Numeric::single, Numeric::dsp32}) {
        const Verdict verdict = judge(scene, render_natively(scene, numeric).frame, numeric);
        EXPECT_GE(verdict.admissible_share(), 0.999) << verdict.report;
        EXPECT_LE(static_cast<double>(verdict.wrong_colors),
                  0.001 * static_cast<double>(verdict.pixels))
            << verdict.report;
    }
}

std::string name_of(const testing::TestParamInfo<Example>& example) { return example.param.name; }

INSTANTIATE_TEST_SUITE_P(Examples, LargerPicture, testing::ValuesIn(example_scenes("64,48")),
                         name_of);

}  // namespace
}  // namespace pxm::test
