// The engines show the picture that the definition says (docs/design.md, decision 4), on small
// images of every example scene; picture_slow_test.cpp has larger ones.
#include <gtest/gtest.h>

#include "tests/support/compile_text.hpp"
#include "tests/support/example_scenes.hpp"
#include "tests/support/referee.hpp"

namespace pxm::test {
namespace {

using namespace host;

class Picture : public testing::TestWithParam<Example> {
  protected:
    const CompiledScene scene_ = compile_text(GetParam().text);

    Verdict verdict(Numeric numeric) const {
        return judge(scene_, render_natively(scene_, numeric).frame, numeric);
    }
};

TEST_P(Picture, in_double_is_the_oracles) {
    const Verdict verdict = this->verdict(Numeric::double_);
    EXPECT_GT(verdict.hits, 0);
    EXPECT_GE(verdict.same_share(), 0.999) << verdict.report;
    EXPECT_EQ(verdict.admissible, verdict.pixels) << verdict.report;
    EXPECT_EQ(verdict.wrong_colors, 0) << verdict.report;
}

TEST_P(Picture, in_float_is_admissible) {
    const Verdict verdict = this->verdict(Numeric::single);
    EXPECT_GE(verdict.admissible_share(), 0.999) << verdict.report;
    EXPECT_EQ(verdict.wrong_colors, 0) << verdict.report;
}

std::string name_of(const testing::TestParamInfo<Example>& example) { return example.param.name; }

INSTANTIATE_TEST_SUITE_P(Examples, Picture, testing::ValuesIn(example_scenes("20,15")), name_of);

/// The eye is inside of every cell, so that all keys are exactly 0.
TEST(PictureOrder, of_equal_keys_is_object_and_then_word) {
    CompiledScene scene =
        compile_text(ifs("octo") + ifs("tetra") +
                     "object a { ifs: tetra sphere: (0,0,0) 40 levels: 2 }"
                     "object b { ifs: octo sphere: (0,0,0) 40 levels: 3 }"
                     "camera { eye: 0.01,0.02,0.03 look: 0,0,1 } image { size: 6,4 }");
    for (const long heap : {256L, 8L, 1L}) {
        scene.heap = heap;
        const Frame frame = render_natively(scene, Numeric::double_).frame;
        const Verdict verdict = judge(scene, frame, Numeric::double_);
        EXPECT_EQ(verdict.same, verdict.pixels) << verdict.report;
        for (const PixelRecord& pixel : frame.pixels) {
            EXPECT_EQ(pixel.object, 0);
            EXPECT_EQ(pixel.word, hash_of({0, 0}));
        }
    }
}

/// With a ratio of 1/2, 2^-n of the diameter is level n (design decision 4).
TEST(PictureDepth, ends_where_p_is_a_share_of_the_object) {
    const CompiledScene scene = compile_text(
        ifs("tetra") +
        "object a { ifs: tetra sphere: (0,0,0) 1.5 }"
        "camera { eye: 0.4,1.3,-5 look: 0,1,0 orthographic: 1e-25 } image { size: 1,1 }");
    for (const Numeric numeric : {Numeric::dsp32, Numeric::single, Numeric::double_}) {
        const PixelRecord pixel = render_natively(scene, numeric).frame.at(0, 0);
        EXPECT_EQ(pixel.level, numeric == Numeric::double_ ? 48 : 20);
    }
}

TEST(Referee, rejects_a_frame_with_another_cell_depth_colour_or_a_hole) {
    const CompiledScene scene = compile_text(scene_of("tetra", "", "size: 20,15"));
    const Frame frame = render_natively(scene, Numeric::double_).frame;
    const Verdict right = judge(scene, frame, Numeric::double_);
    ASSERT_EQ(right.same, right.pixels) << right.report;
    ASSERT_EQ(right.wrong_colors, 0) << right.report;
    const auto hit = std::ranges::find_if(frame.pixels,
                                          [](const PixelRecord& pixel) { return pixel.alpha > 0; });
    ASSERT_NE(hit, frame.pixels.end());
    const auto inadmissible = [&](const auto& change) {
        Frame wrong = frame;
        change(wrong.pixels[static_cast<std::size_t>(hit - frame.pixels.begin())]);
        const Verdict verdict = judge(scene, wrong, Numeric::double_);
        return verdict.pixels - verdict.admissible + verdict.wrong_colors;
    };
    EXPECT_EQ(inadmissible([](PixelRecord& pixel) { pixel.word ^= 1; }), 1);
    EXPECT_EQ(inadmissible([](PixelRecord& pixel) { ++pixel.level; }), 1);
    EXPECT_EQ(inadmissible([](PixelRecord& pixel) { pixel.object = 1; }), 1);
    EXPECT_EQ(inadmissible([](PixelRecord& pixel) { pixel.z *= 1.01F; }), 1);
    EXPECT_EQ(inadmissible([](PixelRecord& pixel) { pixel.color[1] += 0.01F; }), 1);
    EXPECT_EQ(inadmissible([](PixelRecord& pixel) { pixel = {}; }), 1);
}

}  // namespace
}  // namespace pxm::test
