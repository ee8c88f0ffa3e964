#include "host/fractal/exact/turns.hpp"

#include <flint/arith.h>

#include <numeric>

namespace pxm::host::exact {

namespace {

constexpr long largest_order = 720;  // of a turn whose cosine is looked for

}  // namespace

void Turns::expect(long order, FieldTower& field) {
    const long together = std::lcm(order, order_);
    if (together == order_) return;
    if (together > largest_order) throw NotExact{"the number field is too large"};
    // That of cos(2 pi / n); the other turns' are Chebyshev's polynomials in it. Twice the cosine
    // is an algebraic integer, which keeps numbers short.
    fmpz_poly_t minimal;
    fmpz_poly_init(minimal);
    arith_cos_minpoly(minimal, static_cast<ulong>(together));
    Over g;
    const long degree = fmpz_poly_degree(minimal);
    for (long i = 0; i <= degree; ++i) {
        Whole c;
        fmpz_mul_2exp(c.get(), minimal->coeffs + i, static_cast<ulong>(degree - i));
        fmpq_poly_set_fmpz(g.emplace_back().get(), c.get());
    }
    fmpz_poly_clear(minimal);
    if (static_cast<long>(g.size()) - 1 > largest_degree)
        throw NotExact{"the number field is too large"};
    LongReal ball;
    Fraction twice;
    fmpq_set_si(twice.get(), 2, static_cast<ulong>(together));
    arb_cos_pi_fmpq(ball.get(), twice.get(), long_bits);
    arb_mul_2exp_si(ball.get(), ball.get(), 1);
    const Algebraic doubled = field.adjoin(g, ball);
    Algebraic half{0, Polynomial(1)};
    fmpq_poly_scalar_div_si(half.value.get(), half.value.get(), 2);
    cosine_ = field.element(field.lift(doubled) * field.lift(half));
    order_ = together;
}

Algebraic Turns::cosine(const Algebraic& degrees, FieldTower& field) {
    constexpr unsigned long full_turn = 360;
    if (!degrees.value.is_rational()) throw NotExact{"an angle of irrational degrees"};
    Fraction turns;
    fmpq_poly_get_coeff_fmpq(turns.get(), degrees.value.get(), 0);
    Whole all;
    fmpz_set_ui(all.get(), full_turn);
    fmpq_div_fmpz(turns.get(), turns.get(), all.get());
    const fmpz* order = fmpq_denref(turns.get());
    if (fmpz_cmp_si(order, largest_order) > 0) throw NotExact{"the number field is too large"};
    expect(fmpz_get_si(order), field);
    fmpz_set_si(all.get(), order_);
    fmpq_mul_fmpz(turns.get(), turns.get(), all.get());
    fmpz_fdiv_r(fmpq_numref(turns.get()), fmpq_numref(turns.get()), all.get());
    return cosine_of(fmpz_get_si(fmpq_numref(turns.get())), field);
}

Algebraic Turns::cosine_of(long k, const FieldTower& field) const {
    const Polynomial x = field.lift(cosine_);
    Polynomial before(1), value = k == 0 ? before : x;
    for (long i = 1; i < k; ++i) {
        const Polynomial next = remainder(x * value + x * value - before, field.modulus());
        before = value;
        value = next;
    }
    return field.element(value);
}

}  // namespace pxm::host::exact
