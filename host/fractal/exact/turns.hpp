// Turns by rational parts of a circle, and their cosines: all are Chebyshev's polynomials in that
// of the smallest turn, which a field takes in once for many angles.
#pragma once

#include "host/fractal/exact/field_tower.hpp"

namespace pxm::host::exact {

class Turns {
  public:
    /// Takes turns by multiples of 1/order into the field. Throws NotExact.
    void expect(long order, FieldTower& field);
    /// Of rational degrees; throws NotExact for others.
    [[nodiscard]] Algebraic cosine(const Algebraic& degrees, FieldTower& field);

  private:
    /// Of k times the smallest turn: T_k of its cosine.
    [[nodiscard]] Algebraic cosine_of(long k, const FieldTower& field) const;

    long order_ = 1;  // turns by multiples of 1/order have their cosines in the field
    Algebraic cosine_{0, Polynomial(1)};  // of the smallest of them
};

}  // namespace pxm::host::exact
