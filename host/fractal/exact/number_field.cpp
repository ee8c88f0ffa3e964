#include "host/fractal/exact/number_field.hpp"

#include "host/fractal/exact/field_tower.hpp"
#include "host/fractal/exact/turns.hpp"

namespace pxm::host::exact {

struct NumberField::Inside {
    FieldTower field;
    Turns turns;
};

NumberField::NumberField() : inside_(std::make_unique<Inside>()) {}
NumberField::~NumberField() = default;
NumberField::NumberField(NumberField&&) noexcept = default;
NumberField& NumberField::operator=(NumberField&&) noexcept = default;

Algebraic NumberField::add(const Algebraic& a, const Algebraic& b) const {
    return inside_->field.element(inside_->field.lift(a) + inside_->field.lift(b));
}

Algebraic NumberField::subtract(const Algebraic& a, const Algebraic& b) const {
    return inside_->field.element(inside_->field.lift(a) - inside_->field.lift(b));
}

Algebraic NumberField::multiply(const Algebraic& a, const Algebraic& b) const {
    return inside_->field.element(inside_->field.lift(a) * inside_->field.lift(b));
}

Algebraic NumberField::divide(const Algebraic& a, const Algebraic& b) const {
    const Polynomial& modulus = inside_->field.modulus();
    return inside_->field.element(inside_->field.lift(a) *
                                  inverse_modulo(inside_->field.lift(b), modulus));
}

Algebraic NumberField::square_root(const Algebraic& a) {
    const int side = sign(a);
    if (side < 0) throw NotExact{"the square root of a negative number"};
    if (side == 0) return whole(0);
    LongReal ball = inside_->field.value_of(a);
    arb_sqrt(ball.get(), ball.get(), long_bits);
    return inside_->field.adjoin(
        {Polynomial(0) - inside_->field.lift(a), Polynomial(0), Polynomial(1)}, ball);
}

Algebraic NumberField::cosine(const Algebraic& degrees) {
    return inside_->turns.cosine(degrees, inside_->field);
}

void NumberField::expect_turns(long order) { inside_->turns.expect(order, inside_->field); }

Algebraic NumberField::sine(const Algebraic& degrees) {
    constexpr long quarter = 90;
    return cosine(subtract(whole(quarter), degrees));
}

Algebraic NumberField::root(const Polynomial& of, double low, double high) {
    constexpr int halvings = 7'000;
    Over g;
    for (long i = 0; i <= of.degree(); ++i) {
        Fraction c;
        fmpq_poly_get_coeff_fmpq(c.get(), of.get(), i);
        fmpq_poly_set_fmpq(g.emplace_back().get(), c.get());
    }
    LongReal a, b, middle;
    arb_set_d(a.get(), low);
    arb_set_d(b.get(), high);
    const int below = arb_sgn_nonzero(value_at(of, a).get());
    if (below * arb_sgn_nonzero(value_at(of, b).get()) >= 0)
        throw NotExact{"no root is known there"};
    for (int i = 0; i < halvings; ++i) {
        arb_add(middle.get(), a.get(), b.get(), 2 * long_bits);
        arb_mul_2exp_si(middle.get(), middle.get(), -1);
        const int side = arb_sgn_nonzero(value_at(of, middle).get());
        if (side == 0) break;
        (side == below ? a : b) = middle;
    }
    arb_union(middle.get(), a.get(), b.get(), long_bits);
    return inside_->field.adjoin(g, middle);
}

int NumberField::sign(const Algebraic& a) const {
    if (a.value.is_zero()) return 0;
    const int side = arb_sgn_nonzero(inside_->field.value_of(a).get());
    if (side == 0) throw NotExact{"a sign that balls do not tell"};
    return side;
}

double NumberField::approximate(const Algebraic& a) const {
    return arf_get_d(arb_midref(inside_->field.value_of(a).get()), ARF_RND_NEAR);
}

Algebraic NumberField::lifted(const Algebraic& a) const {
    return inside_->field.element(inside_->field.lift(a));
}

long NumberField::degree() const { return inside_->field.modulus().degree(); }

const Polynomial& NumberField::minimal_polynomial() const { return inside_->field.modulus(); }

}  // namespace pxm::host::exact
