// Polynomials with rational coefficients: what elements of a number field are written in. FLINT
// does the arithmetic; this class owns the memory.
#pragma once

#include <flint/fmpq_poly.h>

#include <string>
#include <utility>

#include "host/fractal/exact/thread_memory.hpp"

namespace pxm::host::exact {

class Polynomial {
  public:
    Polynomial() {
        give_back_with_thread();
        fmpq_poly_init(value_);
    }
    explicit Polynomial(long whole) : Polynomial() { fmpq_poly_set_si(value_, whole); }
    Polynomial(const Polynomial& other) : Polynomial() { fmpq_poly_set(value_, other.value_); }
    Polynomial(Polynomial&& other) noexcept : Polynomial() { fmpq_poly_swap(value_, other.value_); }
    Polynomial& operator=(Polynomial other) noexcept {
        fmpq_poly_swap(value_, other.value_);
        return *this;
    }
    ~Polynomial() { fmpq_poly_clear(value_); }

    /// The unknown itself.
    [[nodiscard]] static Polynomial unknown();
    /// The number that a decimal stands for, as it is written: "12.5e-3" is 1/80. Nothing is
    /// rounded. Precondition: digits with or without a point and an exponent.
    [[nodiscard]] static Polynomial decimal(const std::string& text);
    /// The number that a finite double is.
    [[nodiscard]] static Polynomial of_double(double value);

    [[nodiscard]] fmpq_poly_struct* get() { return value_; }
    [[nodiscard]] const fmpq_poly_struct* get() const { return value_; }
    [[nodiscard]] long degree() const { return fmpq_poly_degree(value_); }
    [[nodiscard]] bool is_zero() const { return fmpq_poly_is_zero(value_) != 0; }
    [[nodiscard]] bool is_rational() const { return degree() <= 0; }
    /// How many bits its longest number has.
    [[nodiscard]] long bits() const;
    bool operator==(const Polynomial& other) const {
        return fmpq_poly_equal(value_, other.value_) != 0;
    }

  private:
    fmpq_poly_t value_;
};

[[nodiscard]] Polynomial operator+(const Polynomial& a, const Polynomial& b);
[[nodiscard]] Polynomial operator-(const Polynomial& a, const Polynomial& b);
[[nodiscard]] Polynomial operator*(const Polynomial& a, const Polynomial& b);
/// What is left of `a` modulo `modulus`.
[[nodiscard]] Polynomial remainder(const Polynomial& a, const Polynomial& modulus);
/// a(b) modulo `modulus`.
[[nodiscard]] Polynomial composed(const Polynomial& a, const Polynomial& b,
                                  const Polynomial& modulus);
/// The largest rational that both rationals are whole multiples of.
[[nodiscard]] Polynomial rational_common_divisor(const Polynomial& a, const Polynomial& b);
/// 1 / a modulo `modulus`. Precondition: they have no common factor.
[[nodiscard]] Polynomial inverse_modulo(const Polynomial& a, const Polynomial& modulus);

}  // namespace pxm::host::exact
