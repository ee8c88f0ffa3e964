// Random instructions on one accumulator, each compared with the exact model.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>

#include "pxm/dsp32/accumulator.hpp"
#include "tests/pxm/dsp32/exact_model.hpp"
#include "tests/pxm/dsp32/random_words.hpp"

namespace pxm::dsp32 {

/// Whether an accumulator holds exactly that number, in normal form.
inline bool holds(const Accumulator& a, const exact::Number& number) {
    if (number.digits == 0) return a == Accumulator{};
    const int e = exact::exponent_of(number);
    return a.exponent == e + 128 &&
           exact::Integer{a.mantissa} == exact::floor_at(number, e - 31).digits;
}

/// The next instruction: the accumulator as pxm/dsp32 leaves it and as the model does.
struct Pair {
    Accumulator ours;
    exact::Number model;
};

inline Pair step(const Pair& before, unsigned choice, Word x, Word y) {
    switch (choice % 8) {
        case 0:
            return {multiply(x, y), exact::multiply_add({}, x, y)};
        case 1:
            return {load(x), exact::value(x)};
        case 2:
            return {add(x, y), exact::multiply_add(exact::value(x), y, one)};
        case 3:
            return {subtract(x, y), exact::multiply_add(exact::value(x), y, one, -1)};
        case 4:
            return {negate(x), exact::multiply_add({}, x, one, -1)};
        case 5:
            return {multiply_subtract(before.ours, x, y),
                    exact::multiply_add(before.model, x, y, -1)};
        default:
            return {multiply_add(before.ours, x, y), exact::multiply_add(before.model, x, y)};
    }
}

inline void check_against_model(std::uint64_t seed, int instructions) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    RandomWords words(seed);
    std::mt19937 choices(static_cast<std::uint32_t>(seed));
    Pair pair{{}, {}};
    for (int i = 0; i < instructions; ++i) {
        const Word x = words();
        const Word y = words();
        const auto choice = static_cast<unsigned>(choices());
        pair = step(pair, choice, x, y);
        const bool agree = holds(pair.ours, pair.model) &&
                           store(pair.ours) == exact::word(pair.model) &&
                           round(pair.ours) == exact::rounded(pair.model);
        ASSERT_TRUE(agree) << "instruction " << i << ", kind " << choice % 8 << std::hex << ", x "
                           << x << ", y " << y << ", a.mantissa " << pair.ours.mantissa;
    }
}

}  // namespace pxm::dsp32
