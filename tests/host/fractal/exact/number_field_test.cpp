// Numbers of a field: equal exactly if they are the same number.
#include "host/fractal/exact/number_field.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace pxm::test {
namespace {

using namespace host::exact;

TEST(NumberField, the_golden_ratio_is_twice_a_cosine) {
    NumberField field;
    const Algebraic phi = field.divide(field.add(whole(1), field.square_root(whole(5))), whole(2));
    const Algebraic twice = field.multiply(whole(2), field.cosine(whole(36)));
    EXPECT_TRUE(field.subtract(phi, twice).value.is_zero());
    EXPECT_NEAR(field.approximate(phi), std::numbers::phi, 1e-15);
}

TEST(NumberField, sine_and_cosine_of_one_angle_lie_on_the_circle) {
    for (const long degrees : {30L, 36L, 45L, 60L, 72L, 90L, 135L, 200L, -75L}) {
        NumberField field;
        const Algebraic c = field.cosine(whole(degrees)), s = field.sine(whole(degrees));
        const Algebraic sum = field.add(field.multiply(c, c), field.multiply(s, s));
        EXPECT_TRUE(field.subtract(sum, whole(1)).value.is_zero()) << degrees;
        const double radians = static_cast<double>(degrees) * std::numbers::pi / 180;
        EXPECT_NEAR(field.approximate(c), std::cos(radians), 1e-14) << degrees;
        EXPECT_NEAR(field.approximate(s), std::sin(radians), 1e-14) << degrees;
    }
}

TEST(NumberField, roots_multiply_as_they_should_and_a_near_miss_is_seen) {
    NumberField field;
    const Algebraic product =
        field.multiply(field.square_root(whole(2)), field.square_root(whole(3)));
    EXPECT_TRUE(field.subtract(product, field.square_root(whole(6))).value.is_zero());
    EXPECT_EQ(field.degree(), 4);
    // 99/70 is near the root of two.
    const Algebraic near =
        field.subtract(field.divide(whole(99), whole(70)), field.square_root(whole(2)));
    EXPECT_FALSE(near.value.is_zero());
    EXPECT_EQ(field.sign(near), 1);
}

TEST(NumberField, a_decimal_is_the_fraction_that_it_writes) {
    EXPECT_EQ(Polynomial::decimal("0.125"), Polynomial::of_double(0.125));
    EXPECT_EQ(Polynomial::decimal("12.5e-1"), Polynomial::of_double(1.25));
    EXPECT_FALSE(Polynomial::decimal("0.1") == Polynomial::of_double(0.1));
}

TEST(NumberField, refuses_what_is_too_large_or_no_number) {
    NumberField field;
    EXPECT_THROW((void)field.square_root(whole(-1)), NotExact);
    EXPECT_THROW((void)field.cosine(whole(1)), NotExact);
    EXPECT_THROW((void)field.cosine(field.square_root(whole(2))), NotExact);
}

}  // namespace
}  // namespace pxm::test
