// Reciprocal, divide and square roots: the DSP32 has none in hardware, its library routines do it.
// Each routine is a sequence of multiply-adds of the chip; one statement below is one instruction.
// "quick" is what AT&T's routines reach, the plain names add a Newton step and end with `round`.
// Seed and cost are known, coefficients are our own (docs/arithmetic.md has the accuracies, which
// tests/pxm/dsp32/routines_full_test.cpp measures).
#pragma once

#include "pxm/dsp32/accumulator.hpp"

namespace pxm::dsp32::routines {

/// All bits but the sign inverted: 1/y, too large by 0 to 12.5 %.
[[nodiscard]] constexpr Word reciprocal_seed(Word y) noexcept { return y ^ 0x7FFFFFFFU; }

/// 1/y with a relative error below 1.8e-6 for 2^-126 <= |y| <= 2^126 (the chip's: 7.6e-6). The
/// reciprocal of 0 is the largest number.
[[nodiscard]] constexpr Word reciprocal_quick(Word y) noexcept {
    // With t = y s in [1, 9/8] and d = 1 - t, the cubic P that makes the largest |1 - t P| least:
    // t P = 1 - T4(16 t - 17) / T4(17), T4 the Chebyshev polynomial and T4(17) = 665857.
    constexpr double t4 = 665857.0;
    constexpr Word p0 = word_of(665856.0 / t4);
    constexpr Word p1 = word_of(665600.0 / t4);
    constexpr Word p2 = word_of(655360.0 / t4);
    constexpr Word p3 = word_of(524288.0 / t4);
    const Word seed = reciprocal_seed(y);
    const Word d = store(multiply_subtract(load(one), y, seed));
    Accumulator p = multiply_add(load(p2), p3, d);
    p = multiply_add(load(p1), store(p), d);
    p = multiply_add(load(p0), store(p), d);
    return store(multiply(store(p), seed));
}

/// One Newton step for the reciprocal r of y: r + r (1 - y r).
[[nodiscard]] constexpr Accumulator reciprocal_step(Word y, Word r) noexcept {
    const Word error = store(multiply_subtract(load(one), y, r));
    return multiply_add(load(r), r, error);
}

/// 1/y, to nearest or one beside it. Range and 1/0 as in `reciprocal_quick`.
[[nodiscard]] constexpr Word reciprocal(Word y) noexcept {
    return round(reciprocal_step(y, reciprocal_quick(y)));
}

/// x/y with a relative error below 2e-6: the quick reciprocal, scaled by the numerator.
[[nodiscard]] constexpr Word divide_quick(Word x, Word y) noexcept {
    return store(multiply(x, reciprocal_quick(y)));
}

/// x/y, to nearest or one beside it, for y as above and |x| >= 2^-103 (below that the remainder
/// underflows and the quotient is a quick one). x/0 is huge with the sign of x, and 0/0 is 0.
[[nodiscard]] constexpr Word divide(Word x, Word y) noexcept {
    const Word r = reciprocal_quick(y);
    const Word q = store(multiply(x, r));
    const Word remainder = store(multiply_subtract(load(x), q, y));
    return round(multiply_add(load(q), remainder, r));
}

/// x = mantissa * 4^scale with the mantissa in [1, 2) or, if the exponent is odd, in [2, 4).
struct Quartered {
    Word mantissa;  // in [1, 4)
    bool odd;       // whether the exponent was
    int scale;      // of the power of 4
};

/// The exponent field split in two, with integer instructions. Precondition: x > 0.
[[nodiscard]] constexpr Quartered quartered(Word x) noexcept {
    const int exponent = static_cast<int>(x & 0xFFU) - exponent_bias;
    const Word odd = static_cast<Word>(exponent) & 1U;
    return {(x & 0xFFFFFF00U) | (exponent_bias + odd), odd != 0, exponent >> 1};
}

/// word * 2^scale, by an addition to the exponent field. Precondition: the result is in range.
[[nodiscard]] constexpr Word scaled(Word word, int scale) noexcept {
    return word + static_cast<Word>(scale);
}

/// A root, and about the reciprocal of it.
struct RootEstimate {
    Word root;        // an estimate
    Word reciprocal;  // an estimate of 1 / root
};

/// One Newton step for the root s of v: s + (v - s^2) / (2 s).
[[nodiscard]] constexpr Accumulator root_step(Word v, RootEstimate s) noexcept {
    const Word rest = store(multiply_subtract(load(v), s.root, s.root));
    return multiply_add(load(s.root), rest, scaled(s.reciprocal, -1));
}

/// A line for the root of the mantissa (relative error 0.75 %), then one Newton step.
[[nodiscard]] constexpr RootEstimate mantissa_root_quick(Quartered x) noexcept {
    // Best on [1, 2]: a + b m with a / b = sqrt(2); its error at the ends is that in the middle.
    constexpr Word a = word_of(0.590162067);
    constexpr Word b = word_of(0.417307600);
    constexpr Word root_2 = word_of(1.41421356237309505);
    const Word m = (x.mantissa & 0xFFFFFF00U) | exponent_bias;
    Word s = store(multiply_add(load(a), b, m));
    if (x.odd) s = store(multiply(s, root_2));
    const Word r = reciprocal_quick(s);
    return {store(root_step(x.mantissa, {s, r})), r};
}

/// The square root with a relative error below 3e-5 (the chip's: 1.3e-4). Of a negative number,
/// which a program must test for, the chip makes garbage; chosen: 0.
[[nodiscard]] constexpr Word square_root_quick(Word x) noexcept {
    if (order_key(x) <= 0) return zero;
    const Quartered parts = quartered(x);
    return scaled(mantissa_root_quick(parts).root, parts.scale);
}

/// The square root, to nearest or one beside it. Of 0 and of a negative number: 0.
[[nodiscard]] constexpr Word square_root(Word x) noexcept {
    if (order_key(x) <= 0) return zero;
    const Quartered parts = quartered(x);
    RootEstimate s = mantissa_root_quick(parts);
    // The reciprocal is the line's; one Newton step brings it to the better root.
    s.reciprocal = store(reciprocal_step(s.root, s.reciprocal));
    return scaled(round(root_step(parts.mantissa, s)), parts.scale);
}

/// One Newton step for the reciprocal root r of v: r + r (1/2 - (v/2) r^2).
[[nodiscard]] constexpr Accumulator reciprocal_root_step(Word v, Word r) noexcept {
    constexpr Word half = scaled(one, -1);
    const Word half_v_r = store(multiply(scaled(v, -1), r));
    const Word error = store(multiply_subtract(load(half), half_v_r, r));
    return multiply_add(load(r), r, error);
}

/// 1/sqrt(x) with a relative error below 2^-23: a parabola (relative error 0.32 %) and two Newton
/// steps. Of 0 the largest number, as for the reciprocal; of a negative number, chosen: the same.
[[nodiscard]] constexpr Word reciprocal_square_root(Word x) noexcept {
    constexpr Word c0 = word_of(1.57963909);
    constexpr Word c1 = word_of(-0.730514325);
    constexpr Word c2 = word_of(0.147687586);
    constexpr Word root_half = word_of(0.70710678118654752);
    if (order_key(x) <= 0) return largest;
    const Quartered parts = quartered(x);
    const Word m = (x & 0xFFFFFF00U) | exponent_bias;
    const Word line = store(multiply_add(load(c1), c2, m));
    Word r = store(multiply_add(load(c0), line, m));
    if (parts.odd) r = store(multiply(r, root_half));
    r = store(reciprocal_root_step(parts.mantissa, r));
    return scaled(round(reciprocal_root_step(parts.mantissa, r)), -parts.scale);
}

}  // namespace pxm::dsp32::routines
