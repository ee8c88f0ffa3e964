// Numbers a node can compute with: dsp32::Float, float and double answer to the same functions.
// IEEE sums of products run from left to right with a rounding after each operation; dsp32 keeps
// them in one accumulator (pxm/dsp32/float.hpp), as the chip would.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>

namespace pxm {

/// 32-bit words that one number takes in a node's memory.
template <class Real>
inline constexpr std::uint32_t real_words = sizeof(Real) / sizeof(std::uint32_t);

/// a1 b1 + a2 b2 + a3 b3.
template <std::floating_point Real>
[[nodiscard]] constexpr Real sum_of_products(Real a1, Real b1, Real a2, Real b2, Real a3,
                                             Real b3) noexcept {
    return a1 * b1 + a2 * b2 + a3 * b3;
}

/// addend + a1 b1 + a2 b2 + a3 b3.
template <std::floating_point Real>
[[nodiscard]] constexpr Real sum_of_products(Real addend, Real a1, Real b1, Real a2, Real b2,
                                             Real a3, Real b3) noexcept {
    return addend + a1 * b1 + a2 * b2 + a3 * b3;
}

template <std::floating_point Real>
[[nodiscard]] Real square_root(Real x) noexcept {
    return std::sqrt(x);
}
template <std::floating_point Real>
[[nodiscard]] constexpr Real reciprocal(Real x) noexcept {
    return Real{1} / x;
}
template <std::floating_point Real>
[[nodiscard]] Real reciprocal_square_root(Real x) noexcept {
    return Real{1} / std::sqrt(x);
}
template <std::floating_point Real>
[[nodiscard]] Real absolute(Real x) noexcept {
    return std::fabs(x);
}
template <std::floating_point Real>
[[nodiscard]] constexpr double to_double(Real x) noexcept {
    return static_cast<double>(x);
}

/// The number of a node nearest to a host's double (dsp32: the host's conversion, chopping).
template <class Real>
[[nodiscard]] constexpr Real from_double(double x) noexcept {
    return static_cast<Real>(x);
}

/// The words that hold a number in a node's memory.
[[nodiscard]] constexpr std::array<std::uint32_t, 1> encode(float x) noexcept {
    return {std::bit_cast<std::uint32_t>(x)};
}
[[nodiscard]] constexpr std::array<std::uint32_t, 2> encode(double x) noexcept {
    return std::bit_cast<std::array<std::uint32_t, 2>>(x);
}
/// The number that `real_words<Real>` words hold.
template <class Real>
[[nodiscard]] constexpr Real decode(std::array<std::uint32_t, real_words<Real>> words) noexcept {
    return std::bit_cast<Real>(words);
}

}  // namespace pxm
