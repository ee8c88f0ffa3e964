// Arithmetic for proofs: a real number known to lie between two doubles. Every operation errs
// outward, so what holds for the result holds for the real number. No rounding mode is switched:
// a neighbour of a result computed to nearest is found by [RZBM09].
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace pxm::host {

/// Above the real number whose nearest double is x: the next double or the one after it [RZBM09].
[[nodiscard]] inline double above(double x) {
    constexpr double share = 0x1.0000000000001p-53;
    return x + (std::abs(x) * share + std::numeric_limits<double>::denorm_min());
}
/// Below the real number whose nearest double is x.
[[nodiscard]] inline double below(double x) { return -above(-x); }

/// A real number r with low <= r <= high. What double cannot hold is between -inf and inf: no
/// inequality is proven by it.
struct Bracket {
    double low = 0;   // the least that r may be
    double high = 0;  // the most

    Bracket() = default;
    /// The number x itself: no double is too good to be a bracket.
    Bracket(double x) : Bracket(x, x) {}
    /// A number between the two.
    Bracket(double from, double to) : low(from), high(to) {
        if (std::isfinite(from) && std::isfinite(to)) return;
        low = -std::numeric_limits<double>::infinity();
        high = std::numeric_limits<double>::infinity();
    }

    /// Whether anything is known of it.
    [[nodiscard]] bool is_finite() const { return std::isfinite(low); }
    /// Whether it is 0 for certain.
    [[nodiscard]] bool is_zero() const { return low == 0 && high == 0; }
    /// No smaller than |r|.
    [[nodiscard]] double magnitude() const { return std::max(-low, high); }
    [[nodiscard]] double middle() const { return low / 2 + high / 2; }  // a number within
};

/// Nothing is known.
[[nodiscard]] inline Bracket anything() {
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
}

[[nodiscard]] inline Bracket operator-(const Bracket& a) { return {-a.high, -a.low}; }  // -r
/// The sum.
[[nodiscard]] inline Bracket operator+(const Bracket& a, const Bracket& b) {
    // Zeros stay zeros, here and in products: the powers of a nilpotent map must vanish.
    if (a.is_zero()) return b;
    if (b.is_zero()) return a;
    return {below(a.low + b.low), above(a.high + b.high)};
}
/// The difference.
[[nodiscard]] inline Bracket operator-(const Bracket& a, const Bracket& b) { return a + -b; }

/// The product.
[[nodiscard]] inline Bracket operator*(const Bracket& a, const Bracket& b) {
    if (!a.is_finite() || !b.is_finite()) return anything();
    if (a.is_zero() || b.is_zero()) return {};
    const double p = a.low * b.low;
    const double q = a.low * b.high;
    const double r = a.high * b.low;
    const double s = a.high * b.high;
    return {below(std::min(std::min(p, q), std::min(r, s))),
            above(std::max(std::max(p, q), std::max(r, s)))};
}

/// The quotient; anything, if the divisor may be 0.
[[nodiscard]] inline Bracket operator/(const Bracket& a, const Bracket& b) {
    if (!a.is_finite() || !b.is_finite() || (b.low <= 0 && b.high >= 0)) return anything();
    return a * Bracket{below(1 / b.high), above(1 / b.low)};
}

/// Precondition: r >= 0, though the bracket may begin below.
[[nodiscard]] inline Bracket sqrt(const Bracket& a) {
    return {std::max(below(std::sqrt(std::max(a.low, 0.0))), 0.0), above(std::sqrt(a.high))};
}

}  // namespace pxm::host
