// Sine and cosine for the DSP32. No routine of AT&T's was found, so both are our own: the argument
// is reduced to a quarter turn around a multiple of pi/2, then a Taylor polynomial.
#pragma once

#include "pxm/dsp32/accumulator.hpp"
#include "pxm/dsp32/float.hpp"

namespace pxm::dsp32 {

namespace routines {

/// x = remainder + quarters * pi/2, |remainder| <= pi/4.
struct Quadrant {
    Word remainder;  // |remainder| <= pi/4
    int quarters;    // turns of pi/2
};

/// Precondition: |x| <= 32767 pi/2, so that the quarters fit the chip's 16-bit integers.
[[nodiscard]] constexpr Quadrant quadrant(Word x) noexcept {
    constexpr double half_pi = 1.57079632679489662;
    constexpr Word per_quarter = word_of(1 / half_pi);
    constexpr Word head = word_of(half_pi);  // pi/2 as two words, for 48 bits of it
    constexpr Word tail = word_of(half_pi - double_of(head));
    const int quarters = nearest_integer(multiply(x, per_quarter));
    const Word k = word_of_integer(quarters);
    const Accumulator rest = multiply_subtract(load(x), k, head);
    return {store(multiply_subtract(rest, k, tail)), quarters};
}

/// sin r = r + r z (-1/3! + z (1/5! + z (-1/7! + z/9!))), z = r^2.
[[nodiscard]] constexpr Word sine_near_zero(Word r) noexcept {
    const Word z = store(multiply(r, r));
    Accumulator p = multiply_add(load(word_of(-1.0 / 5040)), word_of(1.0 / 362880), z);
    p = multiply_add(load(word_of(1.0 / 120)), store(p), z);
    p = multiply_add(load(word_of(-1.0 / 6)), store(p), z);
    p = multiply(store(p), z);
    return round(multiply_add(load(r), store(p), r));
}

/// cos r = 1 + z (-1/2! + z (1/4! + z (-1/6! + z/8!))), z = r^2.
[[nodiscard]] constexpr Word cosine_near_zero(Word r) noexcept {
    const Word z = store(multiply(r, r));
    Accumulator p = multiply_add(load(word_of(-1.0 / 720)), word_of(1.0 / 40320), z);
    p = multiply_add(load(word_of(1.0 / 24)), store(p), z);
    p = multiply_add(load(word_of(-0.5)), store(p), z);
    return round(multiply_add(load(one), store(p), z));
}

/// sin(remainder + quarters * pi/2).
[[nodiscard]] constexpr Word sine(Quadrant x) noexcept {
    const bool odd = (x.quarters & 1) != 0;
    const Word value = odd ? cosine_near_zero(x.remainder) : sine_near_zero(x.remainder);
    return (x.quarters & 2) != 0 ? store(negate(value)) : value;
}

}  // namespace routines

/// sin x, x in radians. Beyond +-51471 (2^15 - 1 quarter turns) the value has no meaning.
[[nodiscard]] constexpr Float sine(Float x) noexcept {
    return Float::from_word(routines::sine(routines::quadrant(x.word())));
}

/// cos x, x in radians, in the same range.
[[nodiscard]] constexpr Float cosine(Float x) noexcept {
    routines::Quadrant parts = routines::quadrant(x.word());
    ++parts.quarters;
    return Float::from_word(routines::sine(parts));
}

}  // namespace pxm::dsp32
