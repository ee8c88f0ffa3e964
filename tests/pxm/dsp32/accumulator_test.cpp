// Laws of pxm/dsp32/accumulator: its corners one by one, and random sums against the exact model.
#include "pxm/dsp32/accumulator.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/pxm/dsp32/check_against_model.hpp"

namespace pxm::dsp32 {
namespace {

constexpr Word minus_one = 0x8000007F;
constexpr Word two = 0x00000081;
constexpr Word tiny = 0x00000001;           // 2^-127
constexpr Word tiny_negative = 0xFFFFFF01;  // -(1 + 2^-23) 2^-127

static_assert(store(multiply(minus_one, minus_one)) == one);
static_assert(store(multiply(0x80000080, 0x80000080)) == 0x00000082);  // -2 * -2 = 4
static_assert(store(add(one, minus_one)) == zero);
static_assert(store(negate(one)) == minus_one && store(negate(minus_one)) == one);

TEST(Dsp32Accumulator, load_and_store_are_inverse) {
    RandomWords words(1);
    for (int i = 0; i < 100'000; ++i) {
        const Word word = words();
        EXPECT_EQ(store(load(word)), pack(unpack(word)));
        EXPECT_EQ(round(load(word)), pack(unpack(word)));
    }
}

TEST(Dsp32Accumulator, zero_is_neutral_in_sums_and_absorbs_in_products) {
    RandomWords words(2);
    for (int i = 0; i < 10'000; ++i) {
        const Word x = pack(unpack(words()));
        EXPECT_EQ(store(add(x, zero)), x);
        EXPECT_EQ(store(add(zero, x)), x);
        EXPECT_EQ(store(subtract(x, zero)), x);
        EXPECT_EQ(multiply(x, zero), Accumulator{});
        EXPECT_EQ(multiply_add(load(x), zero, words()), load(x));
        EXPECT_EQ(store(multiply(x, one)), x);
        EXPECT_EQ(store(multiply(x, 0x7FFFFF00)), zero);  // a zero with bits beside its exponent
    }
}

TEST(Dsp32Accumulator, x_minus_x_is_zero) {
    RandomWords words(3);
    for (int i = 0; i < 10'000; ++i) {
        const Word x = words();
        const Word y = words();
        EXPECT_EQ(subtract(x, x), Accumulator{});
        const int e = multiply(x, y).exponent;
        if (e < smallest_exponent || e == largest_exponent) continue;  // may be out of range
        // Not zero, but what the 31 fraction bits of the accumulator had chopped off.
        const Accumulator rest = multiply_subtract(multiply(x, y), x, y);
        EXPECT_LE(rest.mantissa, 0);
    }
}

TEST(Dsp32Accumulator, overflow_saturates_to_the_largest_of_that_sign) {
    EXPECT_EQ(store(add(largest, largest)), largest);
    EXPECT_EQ(store(add(most_negative, most_negative)), most_negative);
    EXPECT_EQ(store(multiply(largest, two)), largest);
    EXPECT_EQ(store(multiply(largest, most_negative)), most_negative);
    EXPECT_EQ(store(multiply(most_negative, most_negative)), largest);
    EXPECT_EQ(store(negate(most_negative)), largest);
    EXPECT_EQ(store(subtract(most_negative, one)), most_negative);
    // Saturation is that of 40 bits: guard bits of the largest are ones.
    EXPECT_EQ(multiply(largest, two), (Accumulator{0xFFFFFFFF, 255}));
    EXPECT_EQ(multiply(most_negative, two), (Accumulator{-0x100000000LL, 255}));
}

TEST(Dsp32Accumulator, only_overflow_raises_the_sticky_flag) {
    overflowed = false;
    EXPECT_EQ(store(multiply(word_of(0x1p-100), word_of(0x1p-100))), zero);
    EXPECT_EQ(store(subtract(one, one)), zero);
    EXPECT_FALSE(overflowed) << "zeros and underflow";
    EXPECT_EQ(store(multiply(word_of(0x1p100), word_of(0x1p100))), largest);
    EXPECT_TRUE(overflowed);
    EXPECT_EQ(store(add(one, one)), word_of(2.0));
    EXPECT_TRUE(overflowed) << "until it is cleared";
    overflowed = false;
}

TEST(Dsp32Accumulator, a_product_beyond_the_range_counts_in_full_until_the_sum_is_judged) {
    // largest * 2 does not fit, largest * 2 - largest does, up to what alignment chops.
    EXPECT_EQ(store(multiply_subtract(load(largest), largest, two)), word_of(-0x1.fffffep127));
    // 2^-127 * 2^-127 is far below the range, and still lowers a sum from which it is subtracted.
    const Accumulator below_one = multiply_subtract(load(one), tiny, tiny);
    EXPECT_LT(below_one.mantissa, load(one).mantissa * 2);
    EXPECT_EQ(store(below_one), 0x7FFFFF7F);
    EXPECT_EQ(multiply_add(load(one), tiny, tiny), load(one));
}

TEST(Dsp32Accumulator, underflow_gives_zero) {
    EXPECT_EQ(multiply(tiny, tiny), Accumulator{});
    EXPECT_EQ(multiply(tiny_negative, tiny), Accumulator{});
    EXPECT_EQ(multiply(tiny, 0x0000007F), Accumulator{});
    EXPECT_EQ(multiply(tiny_negative, 0x0000007F), Accumulator{});
    EXPECT_EQ(negate(tiny), Accumulator{});  // -2^-127 = -2 * 2^-128
    EXPECT_EQ(subtract(0x00000101, tiny), Accumulator{});
}

TEST(Dsp32Accumulator, stores_chop_toward_minus_infinity_for_both_signs) {
    const Accumulator third =
        multiply_add(load(0x2AAAAA7E), word_of(0x1.555555p-2), word_of(0x1p-24));
    EXPECT_NE(third.mantissa % 256, 0);
    EXPECT_EQ(store(third), 0x2AAAAA7E);
    const Accumulator minus = multiply_add(load(minus_one), word_of(-0x1p-30), one);
    EXPECT_EQ(minus.mantissa, -0x80000002LL);  // -(1 + 2^-30), guard bits kept
    EXPECT_EQ(store(minus), word_of(-0x1.000002p0));
    EXPECT_EQ(store(multiply_add(load(one), word_of(0x1p-30), one)), one);
}

TEST(Dsp32Accumulator, guard_bits_reach_the_adder_but_not_the_multiplier) {
    const Accumulator a = multiply_add(load(one), word_of(0x1p-31), one);
    EXPECT_EQ(a.mantissa, 0x80000001);
    EXPECT_EQ(multiply_subtract(a, one, one), load(word_of(0x1p-31)));
    EXPECT_EQ(store(multiply(store(a), one)), one);
}

TEST(Dsp32Accumulator, an_operand_beyond_the_guard_bits_only_lowers_the_sum) {
    for (int distance = 32; distance <= 250; ++distance) {
        const Word big = 0x000000FF;  // 2^127
        const Word small = static_cast<Word>(255 - distance);
        EXPECT_EQ(add(big, small), load(big)) << distance;
        const Accumulator lower = subtract(big, small);
        EXPECT_EQ(lower, (Accumulator{0xFFFFFFFF, 254})) << distance;
    }
}

TEST(Dsp32Accumulator, sums_are_commutative) {
    RandomWords words(4);
    for (int i = 0; i < 100'000; ++i) {
        const Word x = words();
        const Word y = words();
        EXPECT_EQ(add(x, y), add(y, x));
        EXPECT_EQ(multiply(x, y), multiply(y, x));
        EXPECT_EQ(subtract(x, y), sum(negative(widened(y)), widened(x)));
    }
}

TEST(Dsp32Accumulator, round_goes_to_the_nearest_and_ties_go_up) {
    const auto guarded = [](std::int64_t guard) { return Accumulator{0x80000000 + guard, 128}; };
    EXPECT_EQ(round(guarded(127)), one);
    EXPECT_EQ(round(guarded(128)), 0x00000180);
    const auto negative_guarded = [](std::int64_t guard) {
        return Accumulator{-0x90000000LL + guard, 128};
    };
    EXPECT_EQ(round(negative_guarded(-128)), store(negative_guarded(0)));
    EXPECT_EQ(round(negative_guarded(-129)), store(negative_guarded(-256)));
    EXPECT_EQ(round(negative_guarded(128)), store(negative_guarded(256)));
    EXPECT_EQ(round(Accumulator{0xFFFFFFFF, 255}), largest);  // rounds up, out of range
    EXPECT_EQ(round(Accumulator{0xFFFFFFFF, 128}), two);      // carries into the exponent
    EXPECT_EQ(round(Accumulator{-0x80000001LL, 128}), minus_one);
    EXPECT_EQ(round(Accumulator{-0x80000001LL, 1}), zero);  // -2^-127 is out of range
    EXPECT_EQ(round(Accumulator{}), zero);
}

TEST(Dsp32Accumulator, nearest_integer_has_ties_up_and_saturates) {
    const auto nearest = [](double value) { return nearest_integer(load(word_of(value))); };
    EXPECT_EQ(nearest(0.0), 0);
    EXPECT_EQ(nearest(0.5), 1);
    EXPECT_EQ(nearest(0.4999), 0);
    EXPECT_EQ(nearest(-0.5), 0);
    EXPECT_EQ(nearest(-0.5001), -1);
    EXPECT_EQ(nearest(-1e-30), 0);
    EXPECT_EQ(nearest(2.5), 3);
    EXPECT_EQ(nearest(-2.5), -2);
    EXPECT_EQ(nearest(32767.25), 32767);
    EXPECT_EQ(nearest(32768), 32767);
    EXPECT_EQ(nearest(65536), 32767);
    EXPECT_EQ(nearest(1e38), 32767);
    EXPECT_EQ(nearest(-32768), -32768);
    EXPECT_EQ(nearest(-32769), -32768);
    EXPECT_EQ(nearest(-1e38), -32768);
}

TEST(Dsp32Accumulator, floor_integer_is_the_next_integer_below) {
    const auto floor = [](double value) { return floor_integer(load(word_of(value))); };
    EXPECT_EQ(floor(0.0), 0);
    EXPECT_EQ(floor(0.999), 0);
    EXPECT_EQ(floor(-1e-30), -1);
    EXPECT_EQ(floor(-1.0), -1);
    EXPECT_EQ(floor(-1.001), -2);
    EXPECT_EQ(floor(2.75), 2);
    EXPECT_EQ(floor(1e6), 32767);
    EXPECT_EQ(floor(-1e6), -32768);
}

TEST(Dsp32Accumulator, random_operations_agree_with_the_exact_model) {
    check_against_model(/*seed=*/11, /*instructions=*/100'000);
}

}  // namespace
}  // namespace pxm::dsp32
