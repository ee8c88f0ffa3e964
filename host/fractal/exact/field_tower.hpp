// Fields one upon another, each with one generator: the rationals, and what was adjoined to them.
// Elements are polynomials in the generator of the uppermost. A root is adjoined by a primitive
// element, which is found by factoring a norm (B. Trager, see [Trager76]).
#pragma once

#include <vector>

#include "host/fractal/exact/algebraic.hpp"
#include "host/fractal/exact/flint_numbers.hpp"

namespace pxm::host::exact {

inline constexpr long largest_degree = 8;  // of the whole field over the rationals

/// A polynomial over a field: lowest coefficient first.
using Over = std::vector<Polynomial>;

[[nodiscard]] LongReal value_at(const Polynomial& p, const LongReal& x);

class FieldTower {
  public:
    FieldTower();

    [[nodiscard]] const Polynomial& modulus() const { return now().modulus; }
    /// Throws NotExact where its numbers are too long.
    [[nodiscard]] Algebraic element(const Polynomial& p) const;
    /// In the generator of now.
    [[nodiscard]] Polynomial lift(const Algebraic& a) const;
    [[nodiscard]] LongReal value_of(const Algebraic& a) const;
    /// The root of g, a polynomial over the field of now, that lies in `ball`.
    [[nodiscard]] Algebraic adjoin(const Over& g, const LongReal& ball);

  private:
    struct Stage {
        Polynomial modulus;  // monic, whole
        LongReal generator;
        Polynomial former;  // the generator of the stage before
    };

    [[nodiscard]] const Stage& now() const { return stages_.back(); }
    [[nodiscard]] Algebraic grow(const Over& g, const LongReal& ball, long shift,
                                 const Polynomial& minimal);

    std::vector<Stage> stages_;
};

}  // namespace pxm::host::exact
