// The number types a node computes with, float, double and dsp32::Float, under one set of names.
// Kernels are templates over the type and use these names, so that on the machine a sum of products
// stays in an accumulator and a root is the chip's routine, while IEEE types do the plain thing.
// No render computes in long double: it is what `pxm study stability` judges double by.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <limits>

#include "pxm/dsp32/float.hpp"

namespace pxm {

template <typename T>
concept IeeeReal =
    std::same_as<T, float> || std::same_as<T, double> || std::same_as<T, long double>;

template <typename T>
concept Real = IeeeReal<T> || std::same_as<T, dsp32::Float>;

using dsp32::absolute;
using dsp32::floor_integer;
using dsp32::nearest_integer;
using dsp32::reciprocal;
using dsp32::reciprocal_square_root;
using dsp32::square_root;
using dsp32::sum_of_products;
using dsp32::to_double;

/// a1 b1 + a2 b2 + a3 b3, from left to right.
template <IeeeReal R>
[[nodiscard]] constexpr R sum_of_products(R a1, R b1, R a2, R b2, R a3, R b3) noexcept {
    return a1 * b1 + a2 * b2 + a3 * b3;
}

/// addend + a1 b1 + a2 b2 + a3 b3, from left to right.
template <IeeeReal R>
[[nodiscard]] constexpr R sum_of_products(R addend, R a1, R b1, R a2, R b2, R a3, R b3) noexcept {
    return addend + a1 * b1 + a2 * b2 + a3 * b3;
}

/// 1 / x.
template <IeeeReal R>
[[nodiscard]] constexpr R reciprocal(R x) noexcept {
    return R{1} / x;
}
/// The root of x.
template <IeeeReal R>
[[nodiscard]] R square_root(R x) noexcept {
    return std::sqrt(x);
}
/// 1 / the root of x.
template <IeeeReal R>
[[nodiscard]] R reciprocal_square_root(R x) noexcept {
    return R{1} / std::sqrt(x);
}
/// |x|.
template <IeeeReal R>
[[nodiscard]] constexpr R absolute(R x) noexcept {
    return x < R{0} ? -x : x;
}
/// x itself.
template <IeeeReal R>
[[nodiscard]] constexpr double to_double(R x) noexcept {
    return static_cast<double>(x);
}

/// The next integer below. Precondition: it is an int.
template <IeeeReal R>
[[nodiscard]] int floor_integer(R x) noexcept {
    const int toward_zero = static_cast<int>(x);
    return x < static_cast<R>(toward_zero) ? toward_zero - 1 : toward_zero;
}
/// The nearest integer, ties up. Precondition: it is an int.
template <IeeeReal R>
[[nodiscard]] int nearest_integer(R x) noexcept {
    return floor_integer(x + R{0.5});
}

/// The host's double as a node number: rounded to nearest for IEEE, chopped for dsp32.
template <Real R>
[[nodiscard]] constexpr R from_double(double value) noexcept {
    return R(value);
}

/// The largest finite number.
template <Real R>
inline constexpr R largest = std::numeric_limits<R>::max();
template <>
inline constexpr dsp32::Float largest<dsp32::Float> = dsp32::Float::from_word(dsp32::largest);

/// 32-bit words of memory that a number takes.
template <Real R>
inline constexpr std::uint32_t real_words = sizeof(R) / 4;

/// A number as it stands in memory.
template <Real R>
using EncodedReal = std::array<std::uint32_t, real_words<R>>;

/// The memory words of a number; of a double, the word with the sign comes first.
template <Real R>
[[nodiscard]] constexpr EncodedReal<R> encode(R value) noexcept {
    if constexpr (std::same_as<R, dsp32::Float>) {
        return {value.word()};
    } else if constexpr (std::same_as<R, float>) {
        return {std::bit_cast<std::uint32_t>(value)};
    } else if constexpr (std::same_as<R, long double>) {
        EncodedReal<R> words{};
        std::memcpy(words.data(), &value, sizeof value);
        return words;
    } else {
        const auto bits = std::bit_cast<std::uint64_t>(value);
        return {static_cast<std::uint32_t>(bits >> 32), static_cast<std::uint32_t>(bits)};
    }
}

/// The number in memory words.
template <Real R>
[[nodiscard]] constexpr R decode(const EncodedReal<R>& words) noexcept {
    if constexpr (std::same_as<R, dsp32::Float>) {
        return dsp32::Float::from_word(words[0]);
    } else if constexpr (std::same_as<R, float>) {
        return std::bit_cast<float>(words[0]);
    } else if constexpr (std::same_as<R, long double>) {
        R value = 0;
        std::memcpy(&value, words.data(), sizeof value);
        return value;
    } else {
        const auto bits = std::bit_cast<std::uint64_t>(words);
        return std::bit_cast<double>(
            std::endian::native == std::endian::little ? std::rotl(bits, 32) : bits);
    }
}

}  // namespace pxm
