// Laws of what the stability study measures and how it grades.
#include "host/study/grade.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "host/render/alarms.hpp"

namespace pxm::host {
namespace {

/// Pixels a tenth wide, all of them hits at depth 1.
RenderResult picture_of(long pixels) {
    RenderResult result;
    result.frame = Frame({pixels, 1}, {0, 0, pixels, 1});
    result.pixel_at_eye = 0.1;
    for (PixelRecord& pixel : result.frame.pixels) {
        pixel.level = 3;
        pixel.z = 1;
    }
    return result;
}

void miss(PixelRecord& pixel) { pixel = PixelRecord{}; }

TEST(Deviation, the_same_picture_is_nowhere_wrong) {
    const Deviation d = deviation_of(picture_of(10), picture_of(10));
    EXPECT_EQ(d.wrong_share, 0);
    EXPECT_EQ(d.rmse, 0);
    EXPECT_EQ(d.perceived, 0);
    EXPECT_EQ(d.worst_depth, 0);
}

TEST(Deviation, another_hit_is_wrong_and_so_is_more_than_a_pixel) {
    RenderResult picture = picture_of(10);
    miss(picture.frame.pixels[0]);
    picture.frame.pixels[1].z = 1.09F;  // within a pixel
    picture.frame.pixels[2].z = 1.25F;
    picture.frame.pixels[3].z = NAN;
    const Deviation d = deviation_of(picture, picture_of(10));
    EXPECT_NEAR(d.wrong_hits, 0.1, 1e-12);
    EXPECT_NEAR(d.wrong_share, 0.3, 1e-12);
    EXPECT_EQ(d.wrong, (std::vector<char>{1, 0, 1, 1, 0, 0, 0, 0, 0, 0}));
}

TEST(Deviation, depths_are_counted_in_pixels_of_the_picture) {
    RenderResult picture = picture_of(4);
    picture.frame.pixels[0].z = 1.25F;
    EXPECT_NEAR(deviation_of(picture, picture_of(4)).worst_depth, 2.5, 1e-5);
    EXPECT_NEAR(deviation_of(picture, picture_of(4)).mean_depth, 2.5 / 4, 1e-5);
    picture.pixel_growth = 0.1;  // p grows with the depth of the reference
    EXPECT_NEAR(deviation_of(picture, picture_of(4)).worst_depth, 1.25, 1e-5);
}

TEST(Deviation, a_larger_world_is_compared_at_its_scale) {
    RenderResult reference = picture_of(4);
    for (PixelRecord& pixel : reference.frame.pixels) pixel.z = 3;
    EXPECT_EQ(deviation_of(picture_of(4), reference, 3).wrong_share, 0);
    EXPECT_EQ(deviation_of(picture_of(4), reference, 1).wrong_share, 1);
}

TEST(Deviation, the_error_of_colour_is_the_root_of_the_mean_square) {
    RenderResult picture = picture_of(100);
    for (float& c : picture.frame.pixels[7].color) c = 0.5F;
    const Deviation d = deviation_of(picture, picture_of(100));
    EXPECT_NEAR(d.rmse, std::sqrt(0.25 / 100), 1e-9);
    EXPECT_EQ(d.color_99, 0) << "one pixel in a hundred";
    EXPECT_NEAR(d.perceived, 0.01, 1e-12);
}

TEST(Grade, few_wrong_pixels_are_right_more_are_degraded) {
    EXPECT_STREQ(grade_of(0.001, false), "right");
    EXPECT_STREQ(grade_of(0.0011, true), "degraded");
    EXPECT_STREQ(grade_of(0.02, false), "degraded");
}

TEST(Grade, a_failure_without_an_alarm_is_silent) {
    EXPECT_STREQ(grade_of(0.03, true), "reported");
    EXPECT_STREQ(grade_of(0.03, false), "silent");
}

TEST(Grade, only_wrong_pixels_without_an_alarm_of_their_own_are_missed) {
    RenderResult picture = picture_of(10);
    picture.frame.pixels[0].alarms = alarm_precision;
    picture.frame.pixels[5].alarms = alarm_precision;  // a false alarm
    EXPECT_NEAR(missed_share(picture, {1, 1, 1, 0, 0, 0, 0, 0, 0, 0}), 0.2, 1e-12);
    EXPECT_EQ(missed_share(picture, {1, 0, 0, 0, 0, 0, 0, 0, 0, 0}), 0);
}

TEST(Grade, a_pixel_whose_reference_was_given_up_is_wrong) {
    RenderResult reference = picture_of(3);
    reference.frame.pixels[1].alarms = alarm_capped;
    reference.frame.pixels[2].alarms = alarm_precision;
    const Deviation same = deviation_of(picture_of(3), reference);
    EXPECT_EQ(wrong_pixels(same, reference), (std::vector<char>{0, 1, 0}));
    EXPECT_NEAR(share_of(wrong_pixels(same, reference)), 1.0 / 3, 1e-12);
}

TEST(Grade, an_alarm_is_worth_the_wrong_pixels_that_have_it) {
    RenderResult picture = picture_of(4);
    picture.frame.pixels[0].alarms = alarm_overflow;
    picture.frame.pixels[1].alarms = alarm_overflow | alarm_precision;
    const std::vector<char> wrong{0, 1, 1, 0};
    EXPECT_EQ(alarmed_pixels(picture, wrong, alarm_overflow).pixels, 2U);
    EXPECT_EQ(alarmed_pixels(picture, wrong, alarm_overflow).wrong, 1U);
    EXPECT_EQ(alarmed_pixels(picture, wrong, alarm_precision).pixels, 1U);
    EXPECT_EQ(alarmed_pixels(picture, wrong, alarm_floored).pixels, 0U);
}

}  // namespace
}  // namespace pxm::host
