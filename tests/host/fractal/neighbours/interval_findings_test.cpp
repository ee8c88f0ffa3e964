// What balls of certified radius decide, and what they must leave open.
#include "host/fractal/neighbours/interval_findings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/host/fractal/neighbours/findings_of.hpp"

namespace pxm::test {
namespace {

using host::ExactFindings;
using testing::HasSubstr;

TEST(IntervalFindings, images_apart_are_a_cantor_set_of_the_similarity_dimension) {
    const ExactFindings found =
        intervals_of(system_of({"scale: 1/pi", "scale: 1/pi rotate: z,17.3 translate: 1,0,0",
                                "scale: -1/pi,1/pi,1/pi translate: 0,1,0"}));
    EXPECT_EQ(found.overlaps.value, false);
    EXPECT_EQ(found.open_set.value, true);
    EXPECT_EQ(found.connected.value, false);
    EXPECT_EQ(found.totally_disconnected.value, true);
    EXPECT_EQ(found.interior.value, false);
    EXPECT_NEAR(found.hausdorff.value.value(), std::log(3) / std::log(std::numbers::pi), 1e-9);
    EXPECT_NEAR(found.boundary.value.value(), *found.hausdorff.value, 0);
    EXPECT_EQ(found.interval_digits, 60);
    EXPECT_THAT(found.open_set.why, HasSubstr("in intervals of 60 digits"));
    EXPECT_EQ(found.degree, 0);
}

// The gap is 10^-20, which no double of this size has.
TEST(IntervalFindings, a_gap_below_the_digits_of_double_is_seen) {
    const std::string first = "scale: 1/4*(pi/pi)";
    const auto second = [](const char* gap) {
        return std::string("scale: 1/4 translate: (1/4+") + gap + ")*(pi/pi),0,0";
    };
    const std::string third = "scale: 1/4 translate: 3/4,0,0";
    EXPECT_EQ(intervals_of(system_of({first, second("1e-20"), third})).totally_disconnected.value,
              true);
    EXPECT_EQ(intervals_of(system_of({first, second("0"), third})).totally_disconnected.value,
              std::nullopt);
    EXPECT_EQ(intervals_of(system_of({first, second("0"), third})).overlaps.value, std::nullopt);
}

// Equal words and common points are there, and no ball can tell.
TEST(IntervalFindings, equality_is_never_decided) {
    const std::vector<std::string> golden{"scale: 1/phi", "scale: 1/phi translate: 1,0,0",
                                          "scale: 1/phi translate: 0,1,0"};
    for (const BallsOf which : {BallsOf::text, BallsOf::doubles}) {
        const ExactFindings found = intervals_of(system_of(golden), which);
        EXPECT_FALSE(found.overlaps.value);
        EXPECT_FALSE(found.finite.value);
        EXPECT_FALSE(found.connected.value);
        EXPECT_FALSE(found.totally_disconnected.value);
        EXPECT_FALSE(found.hausdorff.value);
        EXPECT_THAT(found.overlaps.why, HasSubstr("were not told apart"));
        // Three areas of 1/phi^2 are more than one.
        EXPECT_EQ(found.open_set.value, false);
    }
}

TEST(IntervalFindings, groups_of_images_that_are_apart_are_told) {
    const ExactFindings found = intervals_of(system_of(
        {"scale: 1/2", "scale: 1/2 translate: 1/2*(pi/pi),0,0", "scale: 1/3 translate: 0,5,0"}));
    EXPECT_EQ(found.connected.value, false);
    EXPECT_FALSE(found.totally_disconnected.value);
    EXPECT_FALSE(found.open_set.value);
}

// Images of the two parts of the attractor fall together in a map that is not injective.
TEST(IntervalFindings, what_falls_together_in_a_map_is_not_called_apart) {
    const ExactFindings found =
        intervals_of(system_of({"scale: 1/4*(pi/pi),0,1/4 translate: 3,0,0",
                                "scale: 1/4 translate: 0,1,0", "scale: 1/4 translate: 0,3,1"}));
    EXPECT_FALSE(found.totally_disconnected.value);
    EXPECT_FALSE(found.overlaps.value);
}

TEST(IntervalFindings, numbers_near_the_doubles_have_twelve_digits) {
    const ExactFindings found =
        intervals_of(system_of({"scale: 1/3", "scale: 1/3 translate: 2/3,0,0"}), BallsOf::doubles);
    EXPECT_EQ(found.interval_digits, 12);
    EXPECT_EQ(found.totally_disconnected.value, true);
    // Other numbers near these are no similitudes.
    EXPECT_FALSE(found.hausdorff.value);
}

// What exact numbers and balls both decide is the same.
TEST(IntervalFindings, agree_with_exact_numbers) {
    for (const auto& maps : std::vector<std::vector<std::string>>{
             {"scale: 1/3", "scale: 1/3 translate: 2/3,0,0"},
             {"scale: 1/3 rotate: z,60", "scale: 1/4 translate: 2,0,0", "scale: 1/4"},
             {"scale: 1/2", "scale: 1/2 translate: 1/2,0,0", "scale: 1/2 translate: 0,1/2,0"},
             {"scale: 2/5 rotate: x,30", "scale: 1/3 rotate: y,45 translate: 1,2,3"},
             {"matrix: 1/3,0,0, 0,1/4,0, 0,0,1/5, 1,0,0",
              "matrix: 1/3,0,0, 0,1/4,0, 0,1/9,1/5, 0,1,1"}}) {
        const ExactFindings exact = exact_of(system_of(maps));
        for (const BallsOf which : {BallsOf::text, BallsOf::doubles}) {
            const ExactFindings found = intervals_of(system_of(maps), which);
            const auto agree = [&](const auto& balls, const auto& numbers) {
                if (balls.value && numbers.value) {
                    EXPECT_EQ(*balls.value, *numbers.value) << maps[0];
                }
            };
            agree(found.overlaps, exact.overlaps);
            agree(found.open_set, exact.open_set);
            agree(found.connected, exact.connected);
            agree(found.totally_disconnected, exact.totally_disconnected);
            agree(found.interior, exact.interior);
        }
    }
}

}  // namespace
}  // namespace pxm::test
