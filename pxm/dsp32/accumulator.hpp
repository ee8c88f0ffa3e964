// The DSP32's 40-bit accumulators a0-a3 and the multiplier and adder before them.
// A mantissa of 24 + 8 guard bits, two's complement and normalised, and an 8-bit exponent. Rules:
// docs/arithmetic.md, after [DSP3210 8.2]. Of the flags, which no kernel reads, V is kept for the
// host.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <type_traits>

#include "pxm/dsp32/word.hpp"

namespace pxm::dsp32 {

inline constexpr int accumulator_fraction_bits = 31;  // of its mantissa
inline constexpr int adder_fraction_bits = 46;        // of a product of two 24-bit mantissas
/// More than a word's mantissa has.
inline constexpr int guard_bits = accumulator_fraction_bits - word_fraction_bits;

/// Exponent of a zero inside the adder: below that of every product, so that the other operand is
/// the one that alignment leaves whole.
inline constexpr int zero_exponent = -512;

/// value = mantissa * 2^(exponent - 128 - 31). Zero is {0, zero_exponent}; otherwise the mantissa
/// is in [2^31, 2^32) or [-2^32, -2^31) and the exponent in 1..255.
struct Accumulator {
    std::int64_t mantissa = 0;     // with accumulator_fraction_bits
    int exponent = zero_exponent;  // with its bias of 128
    bool operator==(const Accumulator&) const = default;
};

/// What the adder takes in: mantissa * 2^(exponent - 128 - 46), in any exponent, not normalised.
struct Addend {
    std::int64_t mantissa;  // with adder_fraction_bits
    int exponent;           // with its bias of 128, of any size
};

/// The flag V, sticky: a sum was above the range. One a thread, which runs one node at a time.
inline thread_local constinit bool overflowed = false;

/// What is left of a sum that is zero or out of range: the largest number of its sign, or zero.
[[nodiscard]] constexpr Accumulator flushed(std::int64_t sum, int exponent) noexcept {
    if (sum == 0 || exponent < smallest_exponent) return {};
    if (!std::is_constant_evaluated()) overflowed = true;
    constexpr std::int64_t limit = std::int64_t{1} << (accumulator_fraction_bits + 1);
    return {sum < 0 ? -limit : limit - 1, largest_exponent};
}

/// The adder's output: normalised, then chopped to 31 fraction bits; then overflow and underflow
/// are judged. Chopping cannot undo the normal form, since it moves toward minus infinity.
[[nodiscard]] constexpr Accumulator normalised(std::int64_t sum, int exponent) noexcept {
    // Doubled plus one, so that counting is defined for sums of 0 and -1 too.
    const auto size = static_cast<std::uint64_t>(sum ^ (sum >> 63)) * 2 + 1;
    const int spare = std::countl_zero(size);
    const int result_exponent = exponent + (62 - adder_fraction_bits) - spare;
    constexpr auto exponents = static_cast<unsigned>(largest_exponent - smallest_exponent);
    const bool in_range = static_cast<unsigned>(result_exponent - smallest_exponent) <= exponents;
    if (!in_range || sum == 0) [[unlikely]]
        return flushed(sum, result_exponent);
    const auto aligned = static_cast<std::int64_t>(static_cast<std::uint64_t>(sum) << spare);
    return {aligned >> (62 - accumulator_fraction_bits), result_exponent};
}

/// The adder. The operand of smaller exponent is shifted right arithmetically, that is chopped
/// toward minus infinity. The sources are silent on shifts beyond the adder's width; chosen: as
/// arithmetic says, so that the smallest negative operand still lowers the sum.
[[nodiscard]] constexpr Accumulator sum(Addend a, Addend b) noexcept {
    const int exponent = std::max(a.exponent, b.exponent);
    const int shift_a = std::min(exponent - a.exponent, 63);
    const int shift_b = std::min(exponent - b.exponent, 63);
    return normalised((a.mantissa >> shift_a) + (b.mantissa >> shift_b), exponent);
}

/// The multiplier: the exact product, at full width. Its exponent has no limits; only the adder's
/// result is judged.
[[nodiscard]] constexpr Addend product(Word x, Word y) noexcept {
    const int a = exponent_field(x);
    const int b = exponent_field(y);
    if (a == 0 || b == 0) return {0, zero_exponent};
    return {std::int64_t{mantissa_of_nonzero(x)} * mantissa_of_nonzero(y), a + b - exponent_bias};
}

/// A word on its way through the multiplier, times one.
[[nodiscard]] constexpr Addend widened(Word word) noexcept {
    const Unpacked number = unpack(word);
    return {std::int64_t{number.mantissa} << word_fraction_bits, number.exponent};
}

/// An accumulator on its way into the adder: with its guard bits.
[[nodiscard]] constexpr Addend widened(Accumulator a) noexcept {
    return {a.mantissa * (1 << (adder_fraction_bits - accumulator_fraction_bits)), a.exponent};
}

/// The negative, before alignment (the sources are silent on where the adder negates).
[[nodiscard]] constexpr Addend negative(Addend a) noexcept { return {-a.mantissa, a.exponent}; }

/// a = word.
[[nodiscard]] constexpr Accumulator load(Word word) noexcept {
    const Unpacked number = unpack(word);
    if (number.mantissa == 0) return {};
    return {std::int64_t{number.mantissa} * (1 << guard_bits), number.exponent};
}

/// a = x * y.
[[nodiscard]] constexpr Accumulator multiply(Word x, Word y) noexcept {
    const Addend p = product(x, y);
    return normalised(p.mantissa, p.exponent);
}

/// a = a + x * y, in one instruction.
[[nodiscard]] constexpr Accumulator multiply_add(Accumulator a, Word x, Word y) noexcept {
    return sum(widened(a), product(x, y));
}

/// a = a - x * y, in one instruction.
[[nodiscard]] constexpr Accumulator multiply_subtract(Accumulator a, Word x, Word y) noexcept {
    return sum(widened(a), negative(product(x, y)));
}

/// a = x + y of two words.
[[nodiscard]] constexpr Accumulator add(Word x, Word y) noexcept {
    return sum(widened(x), widened(y));
}

/// a = x - y of two words.
[[nodiscard]] constexpr Accumulator subtract(Word x, Word y) noexcept {
    return sum(widened(x), negative(widened(y)));
}

/// a = -word. The most negative number saturates, the negative of 2^-127 underflows to zero.
[[nodiscard]] constexpr Accumulator negate(Word word) noexcept {
    const Addend a = negative(widened(word));
    return normalised(a.mantissa, a.exponent);
}

/// The word an accumulator leaves in memory, or takes into the multiplier: guard bits chopped.
[[nodiscard]] constexpr Word store(Accumulator a) noexcept {
    return pack({static_cast<std::int32_t>(a.mantissa >> guard_bits), a.exponent});
}

/// The instruction `round`: to the nearest word, ties to the greater value; the only rounding there
/// is.
[[nodiscard]] constexpr Word round(Accumulator a) noexcept {
    const std::int64_t half = std::int64_t{1} << (guard_bits - 1);
    const Accumulator rounded{(a.mantissa + half) & ~(2 * half - 1), a.exponent};
    const Addend wide = widened(rounded);
    return store(normalised(wide.mantissa, wide.exponent));
}

/// The integer below or at a + 1/2 (nearest, ties up), saturated to the chip's 16 bits.
[[nodiscard]] constexpr int nearest_integer(Accumulator a) noexcept {
    // One more bit than the fraction, so that 1/2 can be added below one.
    const int places = exponent_bias + accumulator_fraction_bits - a.exponent;
    if (places < 16) return a.mantissa < 0 ? -32768 : 32767;
    const std::int64_t twice = a.mantissa >> std::min(places - 1, 63);
    return static_cast<int>(std::clamp<std::int64_t>((twice + 1) >> 1, -32768, 32767));
}

/// The integer below or at a, saturated to the chip's 16 bits (a mode of its control register).
[[nodiscard]] constexpr int floor_integer(Accumulator a) noexcept {
    const int places = exponent_bias + accumulator_fraction_bits - a.exponent;
    if (places < 16) return a.mantissa < 0 ? -32768 : 32767;
    const std::int64_t floor = a.mantissa >> std::min(places, 63);
    return static_cast<int>(std::clamp<std::int64_t>(floor, -32768, 32767));
}

}  // namespace pxm::dsp32
