// Laws of pxm/dsp32/float: operators are accumulator operations with a chopping store.
#include "pxm/dsp32/float.hpp"

#include <gtest/gtest.h>

#include <type_traits>

#include "pxm/dsp32/trigonometry.hpp"
#include "tests/pxm/dsp32/exact_model.hpp"
#include "tests/pxm/dsp32/random_words.hpp"

namespace pxm::dsp32 {
namespace {

static_assert(sizeof(Float) == 4 && std::is_trivially_copyable_v<Float>);
static_assert(Float{1.5} * Float{4} == Float{6} && Float{6.0}.word() == 0x40000082);
static_assert((Float{0.1} + Float{0.2}).word() == 0x19999980 - 2);
static_assert(Float{1} / Float{3} > Float{1.0 / 3} && Float{6} / Float{2} == Float{3});
static_assert(Float{-1} < Float{} && Float{} < Float{1} && -Float{1} == Float{-1});

Float next(RandomWords& words) { return Float::from_word(words()); }

TEST(Dsp32Float, operators_agree_with_the_exact_model) {
    RandomWords words(21);
    for (int i = 0; i < 100'000; ++i) {
        const Float x = next(words);
        const Float y = next(words);
        const exact::Number a = exact::value(x.word());
        ASSERT_EQ((x * y).word(), exact::word(exact::multiply_add({}, x.word(), y.word())));
        ASSERT_EQ((x + y).word(), exact::word(exact::multiply_add(a, y.word(), one)));
        ASSERT_EQ((x - y).word(), exact::word(exact::multiply_add(a, y.word(), one, -1)));
        ASSERT_EQ((-x).word(), exact::word(exact::multiply_add({}, x.word(), one, -1)));
    }
}

TEST(Dsp32Float, comparisons_agree_with_the_exact_values) {
    RandomWords words(22);
    for (int i = 0; i < 100'000; ++i) {
        const Float x = next(words);
        const Float y = next(words);
        const int order = exact::compare(x.word(), y.word());
        ASSERT_EQ(x < y, order < 0);
        ASSERT_EQ(x > y, order > 0);
        ASSERT_EQ(x == y, order == 0);
        ASSERT_EQ(x <= y, order <= 0);
        ASSERT_EQ(x >= y, order >= 0);
        ASSERT_TRUE(x == x && !(x < x));
    }
}

TEST(Dsp32Float, sums_of_products_keep_their_guard_bits_until_one_store) {
    RandomWords words(23);
    for (int i = 0; i < 30'000; ++i) {
        Float v[7];
        for (Float& each : v) each = next(words);
        exact::Number sum = exact::multiply_add({}, v[1].word(), v[2].word());
        exact::Number with_addend =
            exact::multiply_add(exact::value(v[0].word()), v[1].word(), v[2].word());
        for (int k = 3; k < 7; k += 2) {
            sum = exact::multiply_add(sum, v[k].word(), v[k + 1].word());
            with_addend = exact::multiply_add(with_addend, v[k].word(), v[k + 1].word());
        }
        ASSERT_EQ(sum_of_products(v[1], v[2], v[3], v[4], v[5], v[6]).word(), exact::word(sum));
        ASSERT_EQ(sum_of_products(v[0], v[1], v[2], v[3], v[4], v[5], v[6]).word(),
                  exact::word(with_addend));
    }
}

TEST(Dsp32Float, a_sum_of_products_differs_from_separate_stores) {
    const Float x{1 + 0x1p-12};  // x^2 = 1 + 2^-11 + 2^-24, its last bit a guard bit
    EXPECT_EQ(x * x - x * x, Float{});
    EXPECT_EQ(sum_of_products(x, x, -(x * x), Float{1}, x, Float{}), Float{0x1p-24});
}

TEST(Dsp32Float, it_never_holds_a_zero_with_other_bits) {
    EXPECT_EQ(Float::from_word(0xFFFFFF00), Float{});
    EXPECT_EQ(Float::from_word(0xFFFFFF00).word(), zero);
    EXPECT_EQ(Float{} * Float{-3.0}, Float{});
}

TEST(Dsp32Float, absolute_has_no_sign_and_saturates) {
    EXPECT_EQ(absolute(Float{-1.25}), Float{1.25});
    EXPECT_EQ(absolute(Float{1.25}), Float{1.25});
    EXPECT_EQ(absolute(Float{}), Float{});
    EXPECT_EQ(absolute(Float::from_word(most_negative)).word(), largest);
}

TEST(Dsp32Float, conversions_go_through_the_word) {
    EXPECT_EQ(static_cast<double>(Float{-0.375}), -0.375);
    EXPECT_EQ(static_cast<float>(Float{-0.375F}), -0.375F);
    EXPECT_EQ(to_double(Float{12}), 12.0);
    EXPECT_EQ(Float{255U}, Float{255.0});
    EXPECT_EQ(nearest_integer(Float{2.5}), 3);
    EXPECT_EQ(floor_integer(Float{-2.5}), -3);
}

std::uint64_t mixed(std::uint64_t hash, Float value) {
    return (hash ^ value.word()) * 0x100000001B3;  // FNV-1a, a word at a time
}

/// One of each operation on random numbers.
std::uint64_t mix_operations(std::uint64_t hash, Float x, Float y, Float z) {
    hash = mixed(hash, x + y);
    hash = mixed(hash, x - y);
    hash = mixed(hash, x * y);
    hash = mixed(hash, x / y);
    hash = mixed(hash, -x);
    hash = mixed(hash, x < y ? z : -z);
    hash = mixed(hash, sum_of_products(x, y, y, z, z, x));
    hash = mixed(hash, reciprocal(z));
    hash = mixed(hash, square_root(z));
    hash = mixed(hash, reciprocal_square_root(absolute(z)));
    hash = mixed(hash, sine(y));
    hash = mixed(hash, cosine(y));
    return mixed(hash, Float{to_double(x) * to_double(y) / 3});
}

TEST(Dsp32Float, a_million_operations_give_the_same_words_on_every_compiler) {
    RandomWords words(64);
    std::uint64_t hash = 0xCBF29CE484222325;
    for (int i = 0; i < 1'000'000 / 13 + 1; ++i) {
        const Float x = next(words);
        const Float y = next(words);
        hash = mix_operations(hash, x, y, next(words));
    }
    // Generated with g++ 12 and the same with clang++ 14. It changes only if a rule changes.
    EXPECT_EQ(hash, 0x96974FD85853572CU) << std::hex << hash;
}

}  // namespace
}  // namespace pxm::dsp32
