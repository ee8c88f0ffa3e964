// The DSP32's 32-bit memory word, and its conversion from and to IEEE numbers on the host.
//   bit 31: s    bits 30..8: f    bits 7..0: e, bias 128        (docs/arithmetic.md,
//   [DSP3210 3.4.2]) value = M * 2^(e-128),  M = 1 + f/2^23 if s = 0,  M = -2 + f/2^23 if s = 1,  e
//   = 0 means zero
// There is no NaN, infinity, denormal or minus zero. The original DSP32 has no instruction for IEEE
// conversion, so it is the host's work: chopped toward minus infinity like every store of the chip.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>

namespace pxm::dsp32 {

/// A number as it stands in memory.
using Word = std::uint32_t;

inline constexpr int exponent_bias = 128;      // what is added to the exponent that is stored
inline constexpr int largest_exponent = 255;   // as stored
inline constexpr int smallest_exponent = 1;    // as stored; 0 is a zero's
inline constexpr int word_fraction_bits = 23;  // stored; one bit more is implied
inline constexpr int exponent_bits = 8;        // stored

inline constexpr Word zero = 0x00000000;     // the canonical one: every word of exponent 0 is zero
inline constexpr Word one = 0x00000080;      // 1.0
inline constexpr Word largest = 0x7FFFFFFF;  // (2 - 2^-23) * 2^127
inline constexpr Word most_negative = 0x800000FF;  // -2^128

/// value = mantissa * 2^(exponent - 128 - 23); zero is {0, 0}, any other mantissa is normalised:
/// in [2^23, 2^24) or [-2^24, -2^23).
struct Unpacked {
    std::int32_t mantissa;  // with word_fraction_bits
    int exponent;           // as stored, with its bias
    bool operator==(const Unpacked&) const = default;
};

/// The exponent as stored, with its bias; 0 for a zero.
[[nodiscard]] constexpr int exponent_field(Word word) noexcept {
    return static_cast<int>(word & 0xFFU);
}

/// The mantissa of a word that is not zero. The bit between sign and fraction is the sign's
/// complement and is not stored.
[[nodiscard]] constexpr std::int32_t mantissa_of_nonzero(Word word) noexcept {
    return (static_cast<std::int32_t>(word) >> exponent_bits) ^ (1 << word_fraction_bits);
}

/// The number in a word. Every word with e = 0 is zero, whatever its other bits say.
[[nodiscard]] constexpr Unpacked unpack(Word word) noexcept {
    const int exponent = exponent_field(word);
    const std::int32_t unless_zero = -static_cast<std::int32_t>(exponent != 0);  // no branch
    return {mantissa_of_nonzero(word) & unless_zero, exponent};
}

/// The word of a normalised mantissa and an exponent in 1..255, or of zero.
[[nodiscard]] constexpr Word pack(Unpacked number) noexcept {
    if (number.mantissa == 0) return zero;
    const Word field = static_cast<Word>(number.mantissa ^ (1 << word_fraction_bits));
    return (field << exponent_bits) | static_cast<Word>(number.exponent);
}

/// An integer whose order is the order of the values. Precondition: if e = 0, the word is `zero`.
/// On the chip a comparison is a subtraction whose sign is looked at; that calls two numbers equal
/// if their difference underflows (below 2^-127). Here the order is that of the exact values.
[[nodiscard]] constexpr std::int32_t order_key(Word word) noexcept {
    const std::int32_t fields = static_cast<std::int32_t>(word);
    const std::int32_t sign = fields >> 31;  // 0 or -1
    const std::int32_t binade = static_cast<std::int32_t>((word & 0xFFU) << word_fraction_bits);
    return (fields >> exponent_bits) + ((binade ^ sign) - sign);
}

/// The word of mantissa * 2^(exponent - 128 - 62) chopped toward minus infinity to 23 fraction
/// bits, saturated above and zero below the range. Precondition: |mantissa| <= 2^62.
[[nodiscard]] constexpr Word chopped_word(std::int64_t mantissa, int exponent) noexcept {
    if (mantissa == 0) return zero;
    // ~m for negative m: -2^k then counts as one bit shorter than 2^k, as M in [-2,-1) demands.
    const auto size = static_cast<std::uint64_t>(mantissa ^ (mantissa >> 63));
    const int spare = std::countl_zero(size) - 1;
    const auto aligned = static_cast<std::int64_t>(static_cast<std::uint64_t>(mantissa) << spare);
    exponent -= spare;
    if (exponent > largest_exponent) return mantissa < 0 ? most_negative : largest;
    if (exponent < smallest_exponent) return zero;
    return pack({static_cast<std::int32_t>(aligned >> (62 - word_fraction_bits)), exponent});
}

/// The word of an IEEE double: chopped toward minus infinity, saturated beyond the range
/// (infinities too), 0 below it. A NaN, which the host must not send, becomes the largest number:
/// what a chip that saturates exponent 255 makes of it; and not by its sign, which differs between
/// compilers.
[[nodiscard]] constexpr Word word_of(double value) noexcept {
    constexpr int ieee_fraction_bits = 52;
    constexpr int ieee_bias = 1023;
    constexpr std::uint64_t hidden_bit = std::uint64_t{1} << ieee_fraction_bits;
    if (value != value) return largest;
    const auto bits = std::bit_cast<std::uint64_t>(value);
    const int ieee_exponent = static_cast<int>((bits >> ieee_fraction_bits) & 0x7FF);
    if (ieee_exponent == 0) return zero;  // zero, or a denormal far below the range
    const auto size = static_cast<std::int64_t>((bits & (hidden_bit - 1)) | hidden_bit);
    const int exponent = ieee_exponent - ieee_bias + exponent_bias + (62 - ieee_fraction_bits);
    return chopped_word((bits >> 63) != 0 ? -size : size, exponent);
}

/// The word of an IEEE float, by the same rules.
[[nodiscard]] constexpr Word word_of_float(float value) noexcept {
    return word_of(static_cast<double>(value));
}

/// The word of an integer, chopped toward minus infinity. Precondition: |value| <= 2^62.
[[nodiscard]] constexpr Word word_of_integer(std::int64_t value) noexcept {
    return chopped_word(value, exponent_bias + 62);
}

/// The exact value of a word.
[[nodiscard]] constexpr double double_of(Word word) noexcept {
    const Unpacked number = unpack(word);
    const int scale = number.exponent - exponent_bias - word_fraction_bits;
    const auto power = static_cast<std::uint64_t>(1023 + scale) << 52;
    return static_cast<double>(number.mantissa) * std::bit_cast<double>(power);
}

/// The nearest float. The most negative word, -2^128, is out of a float's range and becomes its
/// lowest; below 2^-126 floats are denormal and one binade loses its last bit.
[[nodiscard]] constexpr float float_of(Word word) noexcept {
    if (word == most_negative) return std::numeric_limits<float>::lowest();
    return static_cast<float>(double_of(word));
}

}  // namespace pxm::dsp32
