// The rules of docs/arithmetic.md once more, on exact numbers: compute exactly, then take the floor
// where the rule says so. Written from the rules alone, with no shift, mask or type of pxm/dsp32.
#pragma once

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstdint>

namespace pxm::dsp32::exact {

using Integer = boost::multiprecision::checked_int512_t;  // throws if 512 bits are too few

/// digits * 2^scale.
struct Number {
    Integer digits = 0;
    int scale = 0;
};

inline Integer power_of_two(int exponent) {
    Integer result = 1;
    result <<= static_cast<unsigned>(exponent);
    return result;
}

/// The largest multiple of 2^place that is not above x.
inline Number floor_at(const Number& x, int place) {
    if (x.scale >= place) return {x.digits * power_of_two(x.scale - place), place};
    const Integer step = power_of_two(std::min(place - x.scale, 400));  // 2^400 > any |digits|
    Integer quotient = x.digits / step;
    if (quotient * step > x.digits) --quotient;
    return {quotient, place};
}

/// E with x in [2^E, 2^(E+1)) or in [-2^(E+1), -2^E). Precondition: x is not zero.
inline int exponent_of(const Number& x) {
    const Integer size = x.digits < 0 ? Integer{-x.digits} : x.digits;
    const int top = static_cast<int>(boost::multiprecision::msb(size));
    const bool power = size == power_of_two(top);
    return x.scale + top - (x.digits < 0 && power ? 1 : 0);
}

inline Number value(std::uint32_t word) {
    const int e = static_cast<int>(word % 256);
    const std::int64_t f = word / 256 % 8388608;
    if (e == 0) return {};
    const std::int64_t mantissa = word >= 0x80000000U ? f - 2 * 8388608 : f + 8388608;
    return {mantissa, e - 128 - 23};
}

/// x cut to so many fraction bits, then judged against the exponent's range.
inline Number cut(const Number& x, int fraction_bits) {
    if (x.digits == 0) return {};
    const int e = exponent_of(x);
    if (e < -127) return {};
    if (e <= 127) return floor_at(x, e - fraction_bits);
    const Integer limit = power_of_two(fraction_bits + 1);
    return {x.digits < 0 ? Integer{-limit} : Integer{limit - 1}, 127 - fraction_bits};
}

inline std::uint32_t word(const Number& x) {
    if (x.digits == 0) return 0;
    const int e = exponent_of(x);
    const Integer mantissa = floor_at(x, e - 23).digits;
    const Integer field = (mantissa + 2 * 8388608) % 8388608;
    const std::uint32_t sign = x.digits < 0 ? 0x80000000U : 0U;
    return sign + static_cast<std::uint32_t>(field) * 256 + static_cast<std::uint32_t>(e + 128);
}

/// a + sign * x * y, as one instruction.
inline Number multiply_add(const Number& a, std::uint32_t x, std::uint32_t y, int sign = 1) {
    const Number u = value(x);
    const Number v = value(y);
    const Number product{u.digits * v.digits * sign, u.scale + v.scale};
    if (product.digits == 0) return cut(a, 31);
    if (a.digits == 0) return cut(product, 31);
    // The product's exponent is the sum of its factors', not that of its value.
    const int e = std::max(exponent_of(u) + exponent_of(v), exponent_of(a));
    const int place = e - 46;
    return cut({floor_at(a, place).digits + floor_at(product, place).digits, place}, 31);
}

inline std::uint32_t rounded(const Number& a) {
    if (a.digits == 0) return 0;
    const int place = exponent_of(a) - 23;
    const Number twice = floor_at(a, place - 1);
    const Integer up = twice.digits + 1;  // in half units
    return word(cut(floor_at({up, place - 1}, place), 23));
}

/// -1, 0 or 1 as x is below, equal to or above y.
inline int compare(std::uint32_t x, std::uint32_t y) {
    const Integer a = floor_at(value(x), -200).digits;
    const Integer b = floor_at(value(y), -200).digits;
    return a < b ? -1 : a > b ? 1 : 0;
}

}  // namespace pxm::dsp32::exact
