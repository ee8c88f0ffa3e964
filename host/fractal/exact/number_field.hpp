// A real number field that grows with what it is asked for: the rationals first, then with square
// roots and with sines and cosines of rational degrees. Its elements are polynomials in one
// generator, so that equality is decided, not measured: two elements are equal exactly if their
// polynomials are. Which real number the generator is, is known in balls of certified radius.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "host/fractal/exact/algebraic.hpp"

namespace pxm::host::exact {

class NumberField {
  public:
    NumberField();
    ~NumberField();
    NumberField(NumberField&&) noexcept;
    NumberField& operator=(NumberField&&) noexcept;
    NumberField(const NumberField&) = delete;
    NumberField& operator=(const NumberField&) = delete;

    /// Sums, products and quotients throw NotExact where numbers would grow too long.
    [[nodiscard]] Algebraic add(const Algebraic& a, const Algebraic& b) const;
    [[nodiscard]] Algebraic subtract(const Algebraic& a, const Algebraic& b) const;
    [[nodiscard]] Algebraic multiply(const Algebraic& a, const Algebraic& b) const;
    /// Precondition: b is not zero.
    [[nodiscard]] Algebraic divide(const Algebraic& a, const Algebraic& b) const;

    /// Throws NotExact for what is negative, or where the field would grow too large.
    [[nodiscard]] Algebraic square_root(const Algebraic& a);
    /// Of rational degrees; throws NotExact for others.
    [[nodiscard]] Algebraic cosine(const Algebraic& degrees);
    [[nodiscard]] Algebraic sine(const Algebraic& degrees);
    /// Takes cosines of turns by multiples of 1/order into the field: cheaper at once than one
    /// after the other. Throws NotExact.
    void expect_turns(long order);
    /// The root of a polynomial with rational coefficients that lies between two numbers between
    /// which no other root lies. Throws NotExact if there is no such root.
    [[nodiscard]] Algebraic root(const Polynomial& of, double low, double high);

    /// -1, 0 or 1. Throws NotExact if 2,000 digits do not tell.
    [[nodiscard]] int sign(const Algebraic& a) const;
    [[nodiscard]] double approximate(const Algebraic& a) const;

    /// The same element in the generator of now.
    [[nodiscard]] Algebraic lifted(const Algebraic& a) const;
    [[nodiscard]] long degree() const;
    /// The generator's, monic, with whole coefficients.
    [[nodiscard]] const Polynomial& minimal_polynomial() const;

  private:
    struct Inside;
    std::unique_ptr<Inside> inside_;
};

}  // namespace pxm::host::exact
