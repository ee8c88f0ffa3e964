#include "host/fractal/exact/polynomial.hpp"

#include <flint/fmpq.h>
#include <flint/fmpz.h>
#include <flint/fmpz_vec.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace pxm::host::exact {

namespace {

/// Multiplied by base to the power, which may be negative.
void scale_by_power(Polynomial& value, unsigned long base, long power) {
    fmpz_t factor;
    fmpz_init(factor);
    fmpz_set_ui(factor, base);
    fmpz_pow_ui(factor, factor, static_cast<unsigned long>(std::labs(power)));
    if (power >= 0) {
        fmpq_poly_scalar_mul_fmpz(value.get(), value.get(), factor);
    } else {
        fmpq_poly_scalar_div_fmpz(value.get(), value.get(), factor);
    }
    fmpz_clear(factor);
}

}  // namespace

Polynomial Polynomial::unknown() {
    Polynomial x;
    fmpq_poly_set_coeff_si(x.value_, 1, 1);
    return x;
}

Polynomial Polynomial::decimal(const std::string& text) {
    constexpr unsigned long ten = 10;
    const std::size_t end = std::min(text.find_first_of("eE"), text.size());
    std::string digits;
    long power = end < text.size() ? std::strtol(text.c_str() + end + 1, nullptr, ten) : 0;
    bool fraction = false;
    for (std::size_t i = 0; i < end; ++i) {
        if (text[i] == '.') {
            fraction = true;
            continue;
        }
        digits += text[i];
        if (fraction) --power;
    }
    Polynomial value;
    fmpz_t whole;
    fmpz_init(whole);
    fmpz_set_str(whole, digits.c_str(), ten);
    fmpq_poly_set_fmpz(value.value_, whole);
    fmpz_clear(whole);
    scale_by_power(value, ten, power);
    return value;
}

Polynomial Polynomial::of_double(double value) {
    constexpr int digits = 53;
    int exponent = 0;
    const double mantissa = std::ldexp(std::frexp(value, &exponent), digits);
    Polynomial result(static_cast<long>(mantissa));
    scale_by_power(result, 2, exponent - digits);
    return result;
}

long Polynomial::bits() const {
    const long numerators =
        std::labs(_fmpz_vec_max_bits(fmpq_poly_numref(value_), fmpq_poly_length(value_)));
    return std::max(numerators, static_cast<long>(fmpz_bits(fmpq_poly_denref(value_))));
}

Polynomial operator+(const Polynomial& a, const Polynomial& b) {
    Polynomial c;
    fmpq_poly_add(c.get(), a.get(), b.get());
    return c;
}

Polynomial operator-(const Polynomial& a, const Polynomial& b) {
    Polynomial c;
    fmpq_poly_sub(c.get(), a.get(), b.get());
    return c;
}

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
    Polynomial c;
    fmpq_poly_mul(c.get(), a.get(), b.get());
    return c;
}

Polynomial remainder(const Polynomial& a, const Polynomial& modulus) {
    if (a.degree() < modulus.degree()) return a;
    Polynomial c;
    fmpq_poly_rem(c.get(), a.get(), modulus.get());
    return c;
}

Polynomial composed(const Polynomial& a, const Polynomial& b, const Polynomial& modulus) {
    Polynomial result;
    for (long i = a.degree(); i >= 0; --i) {
        result = remainder(result * b, modulus);
        Polynomial coefficient;
        fmpq_t c;
        fmpq_init(c);
        fmpq_poly_get_coeff_fmpq(c, a.get(), i);
        fmpq_poly_set_fmpq(coefficient.get(), c);
        fmpq_clear(c);
        result = result + coefficient;
    }
    return result;
}

Polynomial rational_common_divisor(const Polynomial& a, const Polynomial& b) {
    fmpq_t x, y;
    fmpq_init(x);
    fmpq_init(y);
    fmpq_poly_get_coeff_fmpq(x, a.get(), 0);
    fmpq_poly_get_coeff_fmpq(y, b.get(), 0);
    fmpq_gcd(x, x, y);
    Polynomial result;
    fmpq_poly_set_fmpq(result.get(), x);
    fmpq_clear(x);
    fmpq_clear(y);
    return result;
}

Polynomial inverse_modulo(const Polynomial& a, const Polynomial& modulus) {
    Polynomial divisor, s, t;
    fmpq_poly_xgcd(divisor.get(), s.get(), t.get(), a.get(), modulus.get());
    return remainder(s, modulus);
}

}  // namespace pxm::host::exact
