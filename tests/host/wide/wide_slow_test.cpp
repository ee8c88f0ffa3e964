// As wide_test.cpp, on larger images.
#include <gtest/gtest.h>

#include "host/wide/tables/eligible.hpp"
#include "host/wide/tile/wide_engine.hpp"
#include "tests/support/compile_text.hpp"
#include "tests/support/example_scenes.hpp"
#include "tests/support/referee.hpp"

namespace pxm::test {
namespace {

using namespace host;

class WideSlow : public testing::TestWithParam<Example> {};

TEST_P(WideSlow, is_admissible) {
    const CompiledScene scene = compile_text(GetParam().text);
    if (!wide::why_not_wide(scene, Numeric::single).empty()) GTEST_SKIP();
    const Verdict verdict = judge(scene, wide::run_wide(scene, {}, {}).frame, Numeric::double_);
    EXPECT_GT(verdict.hits, 0);
    EXPECT_GE(verdict.admissible_share(), 0.999) << verdict.report;
    EXPECT_EQ(verdict.wrong_colors, 0) << verdict.report;
}

std::string name_of(const testing::TestParamInfo<Example>& example) { return example.param.name; }

INSTANTIATE_TEST_SUITE_P(Examples, WideSlow, testing::ValuesIn(example_scenes("80,60")), name_of);

}  // namespace
}  // namespace pxm::test
