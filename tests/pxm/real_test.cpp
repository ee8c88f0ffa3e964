// Laws of pxm/real: one set of names for float, double and dsp32::Float.
#include "pxm/real.hpp"

#include <gtest/gtest.h>

namespace pxm {
namespace {

template <typename T>
class RealNumbers : public testing::Test {};
using Types = testing::Types<float, double, dsp32::Float>;
TYPED_TEST_SUITE(RealNumbers, Types);

static_assert(Real<float> && Real<double> && Real<dsp32::Float> && !Real<int>);
static_assert(real_words<float> == 1 && real_words<double> == 2 && real_words<dsp32::Float> == 1);
static_assert(sum_of_products(1.0, 2.0, 3.0, 4.0, 5.0, 6.0) == 44.0);
static_assert(sum_of_products(100.0F, 1.0F, 2.0F, 3.0F, 4.0F, 5.0F, 6.0F) == 144.0F);

TYPED_TEST(RealNumbers, decode_after_encode_is_the_number) {
    for (const double value : {0.0, 1.0, -1.0, 0.1, -1e20, 3e-20, 0x1.fffffep127}) {
        const auto number = from_double<TypeParam>(value);
        EXPECT_EQ(decode<TypeParam>(encode(number)), number) << value;
    }
}

TYPED_TEST(RealNumbers, sums_of_small_integers_are_exact) {
    const auto r = [](int i) { return TypeParam(i); };
    EXPECT_EQ(sum_of_products(r(1), r(2), r(3), r(4), r(-5), r(6)), r(-16));
    EXPECT_EQ(sum_of_products(r(7), r(1), r(2), r(3), r(4), r(-5), r(6)), r(-9));
}

TYPED_TEST(RealNumbers, routines_of_exact_cases) {
    const auto r = [](double value) { return from_double<TypeParam>(value); };
    EXPECT_EQ(square_root(r(2.25)), r(1.5));
    EXPECT_EQ(reciprocal(r(-4)), r(-0.25));
    EXPECT_EQ(reciprocal_square_root(r(16)), r(0.25));
    EXPECT_EQ(absolute(r(-3)), r(3));
    EXPECT_EQ(to_double(r(-0.375)), -0.375);
    EXPECT_EQ(r(6) / r(-3), r(-2));
}

TYPED_TEST(RealNumbers, integers_are_the_nearest_and_the_next_below) {
    const auto r = [](double value) { return from_double<TypeParam>(value); };
    EXPECT_EQ(nearest_integer(r(2.5)), 3);
    EXPECT_EQ(nearest_integer(r(-2.5)), -2);
    EXPECT_EQ(floor_integer(r(-0.25)), -1);
    EXPECT_EQ(floor_integer(r(7.75)), 7);
}

TYPED_TEST(RealNumbers, nothing_finite_is_above_the_largest) {
    EXPECT_GT(largest<TypeParam>, from_double<TypeParam>(3.4e38));
    EXPECT_EQ(from_double<TypeParam>(to_double(largest<TypeParam>)), largest<TypeParam>);
}

TEST(Real, a_double_is_encoded_with_the_sign_first) {
    EXPECT_EQ(encode(-2.0), (EncodedReal<double>{0xC0000000U, 0U}));
    EXPECT_EQ(encode(1.0F), (EncodedReal<float>{0x3F800000U}));
    EXPECT_EQ(encode(dsp32::Float{-1}), (EncodedReal<dsp32::Float>{0x8000007FU}));
}

TEST(Real, a_long_double_keeps_what_a_double_has_no_bits_for) {
    const long double fine = 1.0L + std::numeric_limits<long double>::epsilon();
    EXPECT_EQ(decode<long double>(encode(fine)), fine);
    EXPECT_LE(std::numeric_limits<long double>::epsilon(), std::numeric_limits<double>::epsilon());
}

TEST(Real, the_machine_chops_where_ieee_rounds) {
    EXPECT_EQ(to_double(from_double<float>(0.1)), static_cast<double>(0.1F));
    EXPECT_LT(to_double(from_double<dsp32::Float>(0.1)), 0.1);
}

}  // namespace
}  // namespace pxm
