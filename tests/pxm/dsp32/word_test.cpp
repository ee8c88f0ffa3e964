// Laws of pxm/dsp32/word.
#include "pxm/dsp32/word.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/pxm/dsp32/random_words.hpp"

namespace pxm::dsp32 {
namespace {

struct TestWord {
    double value;
    Word word;
};

// [DSP3210 3.4.2] and arithmetic; the values that are no words are chopped.
constexpr TestWord test_words[] = {
    {1.0, 0x00000080},      {-1.0, 0x8000007F},     {2.0, 0x00000081},
    {-2.0, 0x80000080},     {0.5, 0x0000007F},      {-0.5, 0x8000007E},
    {1.5, 0x40000080},      {-1.5, 0xC0000080},     {6.0, 0x40000082},
    {-6.0, 0xC0000082},     {240.0, 0x70000087},    {100.0, 0x48000086},
    {0.0, 0x00000000},      {-0.0, 0x00000000},     {0.1, 0x4CCCCC7C},
    {-0.1, 0xB333337C},     {M_PI, 0x490FDA81},     {-M_PI, 0xB6F02581},
    {1.0 / 3, 0x2AAAAA7E},  {-1.0 / 3, 0xD555557E}, {0x1.fffffep127, 0x7FFFFFFF},
    {-0x1p128, 0x800000FF}, {0x1p-127, 0x00000001}, {-0x1.000002p-127, 0xFFFFFF01},
};

static_assert([] {
    for (const TestWord& test : test_words) {
        if (word_of(test.value) != test.word) return false;
    }
    return true;
}());

TEST(Dsp32Word, every_test_word_is_the_word_of_its_value) {
    for (const TestWord& test : test_words) {
        EXPECT_EQ(word_of(test.value), test.word) << test.value;
        const double chopped = double_of(test.word);
        EXPECT_LE(chopped, test.value);
        EXPECT_LE(test.value - chopped, std::abs(test.value) * 0x1p-23);
    }
}

TEST(Dsp32Word, pack_after_unpack_is_the_canonical_word) {
    RandomWords words(1);
    for (int i = 0; i < 100'000; ++i) {
        const Word word = words();
        EXPECT_EQ(pack(unpack(word)), (word & 0xFF) == 0 ? zero : word);
    }
    for (Word e = 1; e <= 255; ++e) {
        for (const Word f : {0x00000000U, 0x00000100U, 0x7FFFFF00U, 0x80000000U, 0xFFFFFF00U}) {
            EXPECT_EQ(pack(unpack(f | e)), f | e);
        }
    }
}

TEST(Dsp32Word, every_word_with_exponent_zero_is_zero) {
    for (const Word word : {0x00000000U, 0x80000000U, 0x7FFFFF00U, 0xFFFFFF00U, 0x12345600U}) {
        EXPECT_EQ(unpack(word), (Unpacked{0, 0}));
        EXPECT_EQ(double_of(word), 0.0);
    }
}

TEST(Dsp32Word, its_double_is_exact) {
    RandomWords words(2);
    for (int i = 0; i < 100'000; ++i) {
        const Word word = words();
        const double m = static_cast<std::int32_t>(word) < 0 ? -2.0 : 1.0;
        const double f = static_cast<double>((word >> 8) & 0x7FFFFF);
        const int e = static_cast<int>(word & 0xFF);
        const double expected = e == 0 ? 0.0 : std::ldexp(m + f * 0x1p-23, e - 128);
        EXPECT_EQ(double_of(word), expected);
        EXPECT_EQ(word_of(expected), pack(unpack(word)));
    }
}

TEST(Dsp32Word, a_double_is_chopped_down_and_to_the_next_word_only) {
    std::mt19937_64 engine(3);
    std::uniform_real_distribution<double> mantissa(-2.0, 2.0);
    std::uniform_int_distribution<int> exponent(-100, 100);
    for (int i = 0; i < 100'000; ++i) {
        const double value = std::ldexp(mantissa(engine), exponent(engine));
        const double chopped = double_of(word_of(value));
        EXPECT_LE(chopped, value);
        EXPECT_LT(value - chopped, std::abs(value) * 0x1p-23);
    }
}

TEST(Dsp32Word, conversion_is_monotone) {
    std::mt19937_64 engine(4);
    for (int i = 0; i < 100'000; ++i) {
        const auto x = std::bit_cast<double>(engine());
        if (std::isnan(x)) continue;
        const double y = std::nextafter(x, std::numeric_limits<double>::infinity());
        EXPECT_LE(double_of(word_of(x)), double_of(word_of(y))) << x;
    }
    for (const double x : {0x1p-127, -0x1p-127, 0x1p128, -0x1p128, 0.0, 1.0, -1.0}) {
        const double below = std::nextafter(x, -std::numeric_limits<double>::infinity());
        EXPECT_LE(double_of(word_of(below)), double_of(word_of(x))) << x;
    }
}

TEST(Dsp32Word, beyond_the_range_conversion_saturates) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const double x : {0x1p128, 1e39, 1e300, infinity}) {
        EXPECT_EQ(word_of(x), largest) << x;
        EXPECT_EQ(word_of(-x), most_negative) << x;
    }
    EXPECT_EQ(word_of(std::nextafter(0x1p128, 0.0)), largest);
}

TEST(Dsp32Word, below_the_range_conversion_gives_zero) {
    for (const double x : {0x1.fffffffffffffp-128, 1e-45, 5e-324}) {
        EXPECT_EQ(word_of(x), zero) << x;
        EXPECT_EQ(word_of(-x), zero) << x;
    }
    EXPECT_EQ(word_of(-0x1p-127), zero);  // -2 * 2^-128: the exponent is out of range
}

TEST(Dsp32Word, nan_becomes_the_largest_number_whatever_its_sign) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(word_of(nan), largest);
    EXPECT_EQ(word_of(-nan), largest);
}

TEST(Dsp32Word, a_float_in_range_survives_the_way_there_and_back) {
    RandomWords words(5);
    for (int i = 0; i < 100'000; ++i) {
        const auto value = std::bit_cast<float>(words());
        if (!std::isnormal(value)) continue;
        EXPECT_EQ(float_of(word_of_float(value)), value);
    }
    EXPECT_EQ(float_of(most_negative), std::numeric_limits<float>::lowest());
    EXPECT_EQ(float_of(largest), std::numeric_limits<float>::max());
    EXPECT_EQ(float_of(0x00000001), 0x1p-127F);
}

TEST(Dsp32Word, integers_are_exact_to_24_bits_and_chopped_beyond) {
    for (int i = -70'000; i <= 70'000; i += 7) EXPECT_EQ(double_of(word_of_integer(i)), i);
    EXPECT_EQ(double_of(word_of_integer(16'777'217)), 16'777'216);
    EXPECT_EQ(double_of(word_of_integer(-16'777'217)), -16'777'218);
}

TEST(Dsp32Word, order_keys_are_ordered_as_values) {
    RandomWords words(6);
    for (int i = 0; i < 100'000; ++i) {
        const Word x = pack(unpack(words()));
        const Word y = pack(unpack(words()));
        EXPECT_EQ(order_key(x) < order_key(y), double_of(x) < double_of(y));
        EXPECT_EQ(order_key(x) == order_key(y), double_of(x) == double_of(y));
    }
}

}  // namespace
}  // namespace pxm::dsp32
