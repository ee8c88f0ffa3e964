// dsp32::Float: one memory word with the operators of a number, so that a kernel written over its
// number type runs in the machine's arithmetic. Each operator is one accumulator operation followed
// by a chopping store; sums of products keep their sum in one accumulator, as the chip would.
#pragma once

#include <compare>
#include <concepts>

#include "pxm/dsp32/accumulator.hpp"
#include "pxm/dsp32/routines.hpp"
#include "pxm/dsp32/word.hpp"

namespace pxm::dsp32 {

/// A DSP32 number. Its word is canonical: of the words with e = 0 it is only ever `zero`.
class Float {
  public:
    constexpr Float() noexcept = default;
    /// The value chopped toward minus infinity, saturated, zero below the range (`word_of`).
    explicit constexpr Float(std::floating_point auto value) noexcept
        : word_(word_of(static_cast<double>(value))) {}
    /// The integer, chopped to the bits of a word.
    explicit constexpr Float(std::integral auto value) noexcept
        : word_(word_of_integer(static_cast<std::int64_t>(value))) {}

    /// The number in a memory word.
    [[nodiscard]] static constexpr Float from_word(Word word) noexcept {
        Float result;
        result.word_ = (word & 0xFFU) == 0 ? zero : word;
        return result;
    }
    [[nodiscard]] constexpr Word word() const noexcept { return word_; }  // as it stands in memory

    /// The exact value.
    explicit constexpr operator double() const noexcept { return double_of(word_); }
    /// The nearest float.
    explicit constexpr operator float() const noexcept { return float_of(word_); }

    /// Chopped, as every result.
    friend constexpr Float operator+(Float x, Float y) noexcept {
        return stored(add(x.word_, y.word_));
    }
    /// Chopped.
    friend constexpr Float operator-(Float x, Float y) noexcept {
        return stored(subtract(x.word_, y.word_));
    }
    /// Chopped.
    friend constexpr Float operator*(Float x, Float y) noexcept {
        return stored(multiply(x.word_, y.word_));
    }
    /// By routines::divide.
    friend constexpr Float operator/(Float x, Float y) noexcept {
        return from_word(routines::divide(x.word_, y.word_));
    }
    constexpr Float operator-() const noexcept { return stored(negate(word_)); }  // chopped
    constexpr Float operator+() const noexcept { return *this; }  // the number itself

    /// X = x + other.
    constexpr Float& operator+=(Float other) noexcept { return *this = *this + other; }
    /// X = x - other.
    constexpr Float& operator-=(Float other) noexcept { return *this = *this - other; }
    /// X = x * other.
    constexpr Float& operator*=(Float other) noexcept { return *this = *this * other; }
    /// X = x / other.
    constexpr Float& operator/=(Float other) noexcept { return *this = *this / other; }

    constexpr bool operator==(const Float&) const noexcept = default;  // the same number
    /// By their exact values.
    friend constexpr std::strong_ordering operator<=>(Float x, Float y) noexcept {
        return order_key(x.word_) <=> order_key(y.word_);
    }

    /// What an accumulator leaves in memory.
    [[nodiscard]] static constexpr Float stored(Accumulator a) noexcept {
        Float result;
        result.word_ = store(a);
        return result;
    }

  private:
    Word word_ = zero;
};

/// a1 b1 + a2 b2 + a3 b3 in one accumulator, stored once.
[[nodiscard]] constexpr Float sum_of_products(Float a1, Float b1, Float a2, Float b2, Float a3,
                                              Float b3) noexcept {
    Accumulator a = multiply(a1.word(), b1.word());
    a = multiply_add(a, a2.word(), b2.word());
    a = multiply_add(a, a3.word(), b3.word());
    return Float::stored(a);
}

/// addend + a1 b1 + a2 b2 + a3 b3 in one accumulator, stored once.
[[nodiscard]] constexpr Float sum_of_products(Float addend, Float a1, Float b1, Float a2, Float b2,
                                              Float a3, Float b3) noexcept {
    Accumulator a = multiply_add(load(addend.word()), a1.word(), b1.word());
    a = multiply_add(a, a2.word(), b2.word());
    a = multiply_add(a, a3.word(), b3.word());
    return Float::stored(a);
}

/// The routines of routines.hpp on numbers.
[[nodiscard]] constexpr Float reciprocal(Float x) noexcept {
    return Float::from_word(routines::reciprocal(x.word()));
}
/// By routines::square_root.
[[nodiscard]] constexpr Float square_root(Float x) noexcept {
    return Float::from_word(routines::square_root(x.word()));
}
/// By routines::reciprocal_square_root.
[[nodiscard]] constexpr Float reciprocal_square_root(Float x) noexcept {
    return Float::from_word(routines::reciprocal_square_root(x.word()));
}

/// |x|: the negative of a negative number. That of the most negative is the largest number.
[[nodiscard]] constexpr Float absolute(Float x) noexcept {
    return static_cast<std::int32_t>(x.word()) < 0 ? -x : x;
}

/// The exact value.
[[nodiscard]] constexpr double to_double(Float x) noexcept { return double_of(x.word()); }

/// The nearest integer, ties up, within 16 bits; and the next integer below.
[[nodiscard]] constexpr int nearest_integer(Float x) noexcept {
    return nearest_integer(load(x.word()));
}
/// The next integer below, within 16 bits.
[[nodiscard]] constexpr int floor_integer(Float x) noexcept {
    return floor_integer(load(x.word()));
}

}  // namespace pxm::dsp32
