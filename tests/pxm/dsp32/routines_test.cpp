// Laws of pxm/dsp32/routines: corners, and the stated accuracies on a sparse sweep
// (routines_full_test.cpp sweeps every mantissa).
#include "tests/pxm/dsp32/sweep.hpp"

namespace pxm::dsp32::routines {
namespace {

TEST(Dsp32Routines, the_accuracies_stated_in_their_contracts_hold) {
    sweep_mantissas(/*stride=*/509);
}

TEST(Dsp32Routines, the_seed_is_high_by_no_more_than_an_eighth) {
    RandomWords words(31);
    for (int i = 0; i < 100'000; ++i) {
        const Word y = words();
        const int e = unpack(y).exponent;
        if (e == 0 || e == 255) continue;
        const double t = double_of(y) * double_of(reciprocal_seed(y));
        EXPECT_GE(t, 1.0 - 0x1p-23);
        EXPECT_LE(t, 1.125 + 0x1p-23);
    }
}

TEST(Dsp32Routines, reciprocal_of_zero_is_the_largest_number) {
    EXPECT_EQ(reciprocal(zero), largest);
    EXPECT_EQ(reciprocal_quick(zero), largest);
    EXPECT_EQ(reciprocal_square_root(zero), largest);
}

TEST(Dsp32Routines, division_by_zero_is_huge_and_zero_by_zero_is_zero) {
    EXPECT_EQ(divide(one, zero), largest);
    EXPECT_EQ(divide(word_of(-1.0), zero), most_negative);
    EXPECT_EQ(divide(zero, zero), zero);
    EXPECT_EQ(divide(zero, word_of(-3.0)), zero);
    EXPECT_GT(double_of(divide(word_of(1e-10), zero)), 1e28);
}

TEST(Dsp32Routines, results_that_are_words_are_exact) {
    for (int i = 1; i <= 1000; ++i) {
        const Word x = word_of_integer(i);
        EXPECT_EQ(square_root(word_of_integer(i * i)), x) << i;
        EXPECT_EQ(divide(x, x), one) << i;
        EXPECT_EQ(divide(word_of_integer(7 * i), x), word_of(7.0)) << i;
        EXPECT_EQ(divide(word_of_integer(-7 * i), x), word_of(-7.0)) << i;
    }
    for (int e = -126; e <= 126; ++e) {
        const double power = std::ldexp(1.0, e);
        EXPECT_EQ(reciprocal(word_of(power)), word_of(1 / power)) << e;
        EXPECT_EQ(reciprocal(word_of(-power)), word_of(-1 / power)) << e;
    }
}

TEST(Dsp32Routines, a_quotient_of_a_tiny_numerator_is_at_least_a_quick_one) {
    for (int e = -126; e <= -100; ++e) {
        for (const double m : {1.0, 1.3, -1.7}) {
            const double x = std::ldexp(m, e);
            const double quotient = double_of(divide(word_of(x), word_of(0.7)));
            const double error = e < -103 ? 2.1e-6 : 0x1p-23;
            EXPECT_NEAR(quotient * double_of(word_of(0.7)) / double_of(word_of(x)), 1.0, error);
        }
    }
}

TEST(Dsp32Routines, results_scale_with_powers_of_two) {
    RandomWords words(32);
    for (int i = 0; i < 10'000; ++i) {
        const Word mantissa = words() & 0xFFFFFF00U;
        const Word base = mantissa | 128U;
        for (const int e : {-125, -50, -1, 1, 50, 125}) {
            const Word y = scaled(base, e);
            EXPECT_EQ(reciprocal(y), scaled(reciprocal(base), -e));
            EXPECT_EQ(divide(one, y), scaled(divide(one, base), -e));
            if (e < -100) continue;
            EXPECT_EQ(divide(y, 0x12345680), scaled(divide(base, 0x12345680), e));
            if ((y >> 31) != 0 || e % 2 != 0) continue;
            EXPECT_EQ(square_root(y), scaled(square_root(base), e / 2));
            EXPECT_EQ(reciprocal_square_root(y), scaled(reciprocal_square_root(base), -e / 2));
        }
    }
}

TEST(Dsp32Routines, roots_hold_to_both_ends_of_the_range) {
    for (const Word x : {Word{0x00000001}, Word{0x7FFFFF01}, Word{0x00000002}, largest}) {
        const double root = std::sqrt(double_of(x));
        EXPECT_NEAR(double_of(square_root(x)) / root, 1.0, 0x1p-23);
        EXPECT_NEAR(double_of(reciprocal_square_root(x)) * root, 1.0, 0x1p-23);
    }
}

TEST(Dsp32Routines, roots_of_zero_and_of_negative_numbers_are_as_documented) {
    EXPECT_EQ(square_root(zero), zero);
    EXPECT_EQ(square_root_quick(zero), zero);
    for (const Word x : {word_of(-1.0), most_negative, Word{0xFFFFFF01}}) {
        EXPECT_EQ(square_root(x), zero);
        EXPECT_EQ(square_root_quick(x), zero);
        EXPECT_EQ(reciprocal_square_root(x), largest);
    }
}

TEST(Dsp32Routines, sine_and_cosine_of_landmarks) {
    EXPECT_EQ(sine(Float{}), Float{});
    EXPECT_EQ(cosine(Float{}), Float{1});
    EXPECT_NEAR(to_double(sine(Float{M_PI / 2})), 1.0, 2e-7);
    EXPECT_NEAR(to_double(sine(Float{M_PI / 6})), 0.5, 2e-7);
    EXPECT_NEAR(to_double(cosine(Float{M_PI})), -1.0, 2e-7);
}

}  // namespace
}  // namespace pxm::dsp32::routines
