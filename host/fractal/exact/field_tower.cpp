#include "host/fractal/exact/field_tower.hpp"

#include <arb_fmpz_poly.h>
#include <flint/fmpz_poly_factor.h>

#include <optional>
#include <utility>

namespace pxm::host::exact {

namespace {

constexpr long largest_norm = 36;  // degree of what is factored for one more number
constexpr long longest = 4'096;    // bits of a number in an element
constexpr long most_shifts = 40;   // primitive elements tried

void trim(Over& p) {
    while (!p.empty() && p.back().is_zero()) p.pop_back();
}

/// The monic greatest common divisor over the field of that modulus.
Over common_divisor(Over a, Over b, const Polynomial& modulus) {
    trim(a);
    trim(b);
    while (!b.empty()) {
        const Polynomial inverse = inverse_modulo(b.back(), modulus);
        while (a.size() >= b.size()) {
            const Polynomial q = remainder(a.back() * inverse, modulus);
            const std::size_t shift = a.size() - b.size();
            for (std::size_t i = 0; i < b.size(); ++i)
                a[shift + i] = remainder(a[shift + i] - q * b[i], modulus);
            trim(a);
        }
        std::swap(a, b);
    }
    const Polynomial inverse = inverse_modulo(a.back(), modulus);
    for (Polynomial& c : a) c = remainder(c * inverse, modulus);
    return a;
}

/// sum of g[k] y^k at y = `at`, in the ring of polynomials.
template <class Reduce>
Polynomial evaluated(const Over& g, const Polynomial& at, const Reduce& reduce) {
    Polynomial sum;
    for (std::size_t k = g.size(); k-- > 0;) sum = reduce(sum * at + g[k]);
    return sum;
}

/// Res_y(f(y), g(x - s y, y)): the norm of g, shifted by s generators, as a polynomial in x, from
/// its values at whole numbers.
Polynomial norm(const Polynomial& f, const Over& g, long shift) {
    const long degree = f.degree() * (static_cast<long>(g.size()) - 1);
    const Polynomial steps = Polynomial(shift) * Polynomial::unknown();
    // Newton's divided differences.
    std::vector<Polynomial> difference;
    for (long x = 0; x <= degree; ++x) {
        const Polynomial value =
            evaluated(g, Polynomial(x) - steps, [&](Polynomial p) { return remainder(p, f); });
        Fraction r;
        fmpq_poly_resultant(r.get(), f.get(), value.get());
        Polynomial rational;
        fmpq_poly_set_fmpq(rational.get(), r.get());
        difference.push_back(rational);
    }
    for (long order = 1; order <= degree; ++order)
        for (long i = degree; i >= order; --i) {
            Polynomial& d = difference[static_cast<std::size_t>(i)];
            d = d - difference[static_cast<std::size_t>(i - 1)];
            fmpq_poly_scalar_div_si(d.get(), d.get(), order);
        }
    Polynomial sum;
    for (long i = degree; i >= 0; --i)
        sum =
            sum * (Polynomial::unknown() - Polynomial(i)) + difference[static_cast<std::size_t>(i)];
    return sum;
}

/// The irreducible factor that vanishes there; nothing if balls do not tell which.
std::optional<Polynomial> vanishing_factor(const Polynomial& p, const LongReal& at) {
    fmpz_poly_t primitive;
    fmpz_poly_init(primitive);
    fmpq_poly_get_numerator(primitive, p.get());
    fmpz_poly_factor_t factors;
    fmpz_poly_factor_init(factors);
    fmpz_poly_factor(factors, primitive);
    std::optional<Polynomial> found;
    bool clear = true;
    for (long i = 0; i < factors->num; ++i) {
        LongReal value;
        arb_fmpz_poly_evaluate_arb(value.get(), factors->p + i, at.get(), long_bits);
        if (arb_contains_zero(value.get()) == 0) continue;
        if (found) clear = false;
        found.emplace();
        fmpq_poly_set_fmpz_poly(found->get(), factors->p + i);
    }
    fmpz_poly_factor_clear(factors);
    fmpz_poly_clear(primitive);
    return clear ? found : std::nullopt;
}

bool is_squarefree(const Polynomial& p) {
    return p.degree() >= 1 && fmpq_poly_is_squarefree(p.get()) != 0;
}

Polynomial leading(const Polynomial& p) {
    Fraction c;
    fmpq_poly_get_coeff_fmpq(c.get(), p.get(), p.degree());
    Polynomial result;
    fmpq_poly_set_fmpq(result.get(), c.get());
    return result;
}

Polynomial divided(Polynomial p, const Polynomial& rational) {
    Fraction c;
    fmpq_poly_get_coeff_fmpq(c.get(), rational.get(), 0);
    fmpq_poly_scalar_div_fmpq(p.get(), p.get(), c.get());
    return p;
}

/// The minimal polynomial of c x, where c is the leading coefficient of x's: monic and whole.
Polynomial made_whole(const Polynomial& p, const Polynomial& c) {
    const long n = p.degree();
    Polynomial result;
    Polynomial power(1);  // c^(n - 1 - i)
    Fraction coefficient, factor;
    fmpq_poly_set_coeff_si(result.get(), n, 1);
    for (long i = n - 1; i >= 0; --i) {
        fmpq_poly_get_coeff_fmpq(coefficient.get(), p.get(), i);
        fmpq_poly_get_coeff_fmpq(factor.get(), power.get(), 0);
        fmpq_mul(coefficient.get(), coefficient.get(), factor.get());
        fmpq_poly_set_coeff_fmpq(result.get(), i, coefficient.get());
        power = power * c;
    }
    return result;
}

}  // namespace

LongReal value_at(const Polynomial& p, const LongReal& x) {
    LongReal sum, c;
    Fraction fraction;
    for (long i = p.degree(); i >= 0; --i) {
        fmpq_poly_get_coeff_fmpq(fraction.get(), p.get(), i);
        arb_set_fmpq(c.get(), fraction.get(), long_bits);
        arb_mul(sum.get(), sum.get(), x.get(), long_bits);
        arb_add(sum.get(), sum.get(), c.get(), long_bits);
    }
    return sum;
}

FieldTower::FieldTower() {
    Stage rationals;
    rationals.modulus = Polynomial::unknown();  // the generator is 0
    stages_.push_back(rationals);
}

Algebraic FieldTower::element(const Polynomial& p) const {
    if (p.bits() > longest) throw NotExact{"its numbers have too many digits"};
    return {static_cast<int>(stages_.size()) - 1, remainder(p, now().modulus)};
}

Polynomial FieldTower::lift(const Algebraic& a) const {
    if (a.value.is_rational()) return a.value;
    Polynomial p = a.value;
    for (std::size_t s = static_cast<std::size_t>(a.stage) + 1; s < stages_.size(); ++s)
        p = composed(p, stages_[s].former, stages_[s].modulus);
    return p;
}

LongReal FieldTower::value_of(const Algebraic& a) const {
    return value_at(lift(a), now().generator);
}

Algebraic FieldTower::adjoin(const Over& g, const LongReal& ball) {
    const Stage stage = now();
    if (stage.modulus.degree() * (static_cast<long>(g.size()) - 1) > largest_norm)
        throw NotExact{"the number field is too large"};
    for (long shift = 0; shift < most_shifts; ++shift) {
        const Polynomial product = norm(stage.modulus, g, shift);
        if (!is_squarefree(product)) continue;
        LongReal sum;  // of the root and `shift` generators
        arb_mul_si(sum.get(), stage.generator.get(), shift, long_bits);
        arb_add(sum.get(), sum.get(), ball.get(), long_bits);
        const auto minimal = vanishing_factor(product, sum);
        if (!minimal) throw NotExact{"balls do not tell roots apart"};
        if (minimal->degree() > stage.modulus.degree()) return grow(g, ball, shift, *minimal);
        // It is in the field already: the only common root of g(x) and minimal(x + shift theta).
        const Polynomial theta = remainder(Polynomial::unknown(), stage.modulus);
        Over shifted;
        Over powers{Polynomial(1)};  // of x + shift theta
        for (long i = 0; i <= minimal->degree(); ++i) {
            Fraction c;
            fmpq_poly_get_coeff_fmpq(c.get(), minimal->get(), i);
            Polynomial coefficient;
            fmpq_poly_set_fmpq(coefficient.get(), c.get());
            shifted.resize(powers.size());
            for (std::size_t k = 0; k < powers.size(); ++k)
                shifted[k] = shifted[k] + coefficient * powers[k];
            Over next(powers.size() + 1);
            for (std::size_t k = 0; k < powers.size(); ++k) {
                next[k + 1] = next[k + 1] + powers[k];
                next[k] = remainder(next[k] + Polynomial(shift) * theta * powers[k], stage.modulus);
            }
            powers = next;
        }
        const Over linear = common_divisor(g, shifted, stage.modulus);
        if (linear.size() != 2) throw NotExact{"a root was not separated"};
        return element(Polynomial(0) - linear[0]);
    }
    throw NotExact{"no primitive element was found"};
}

Algebraic FieldTower::grow(const Over& g, const LongReal& ball, long shift,
                           const Polynomial& minimal) {
    if (minimal.degree() > largest_degree) throw NotExact{"the number field is too large"};
    const Stage before = now();
    const Polynomial c = leading(minimal);
    Stage stage;
    stage.modulus = made_whole(minimal, c);
    arb_mul_si(stage.generator.get(), before.generator.get(), shift, long_bits);
    arb_add(stage.generator.get(), stage.generator.get(), ball.get(), long_bits);
    const LongReal scale = value_at(c, before.generator);
    arb_mul(stage.generator.get(), stage.generator.get(), scale.get(), long_bits);
    // gamma = root + shift theta; theta is the common root of f(y) and g(gamma - shift y, y).
    const Polynomial gamma = divided(Polynomial::unknown(), c);
    const auto reduce = [&](const Polynomial& p) { return remainder(p, stage.modulus); };
    Over f;
    for (long i = 0; i <= before.modulus.degree(); ++i) {
        Fraction coefficient;
        fmpq_poly_get_coeff_fmpq(coefficient.get(), before.modulus.get(), i);
        fmpq_poly_set_fmpq(f.emplace_back().get(), coefficient.get());
    }
    const auto product = [&](const Over& a, const Over& b) {
        Over p(a.size() + b.size() - 1);
        for (std::size_t i = 0; i < a.size(); ++i)
            for (std::size_t k = 0; k < b.size(); ++k) p[i + k] = reduce(p[i + k] + a[i] * b[k]);
        return p;
    };
    Over shifted{Polynomial(0)};
    const Over step{reduce(gamma), Polynomial(-shift)};
    for (std::size_t k = g.size(); k-- > 0;) {
        shifted = product(shifted, step);
        for (long i = 0; i <= g[k].degree(); ++i) {
            Fraction coefficient;
            fmpq_poly_get_coeff_fmpq(coefficient.get(), g[k].get(), i);
            Polynomial rational;
            fmpq_poly_set_fmpq(rational.get(), coefficient.get());
            if (shifted.size() <= static_cast<std::size_t>(i)) shifted.resize(i + 1);
            shifted[i] = shifted[i] + rational;
        }
    }
    const Over linear = common_divisor(f, shifted, stage.modulus);
    if (linear.size() != 2) throw NotExact{"a generator was not separated"};
    stage.former = Polynomial(0) - linear[0];
    stages_.push_back(stage);
    return element(reduce(gamma) - Polynomial(shift) * stage.former);
}

}  // namespace pxm::host::exact
