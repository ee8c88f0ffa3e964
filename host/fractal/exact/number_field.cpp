#include "host/fractal/exact/number_field.hpp"

#include <arb.h>
#include <arb_fmpz_poly.h>
#include <flint/arith.h>
#include <flint/fmpq.h>
#include <flint/fmpz.h>
#include <flint/fmpz_poly_factor.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>

#include "host/fractal/exact/thread_memory.hpp"

namespace pxm::host::exact {

namespace {

constexpr long largest_degree = 8;   // of the whole field over the rationals
constexpr long largest_norm = 36;    // degree of what is factored for one more number
constexpr long bits = 6'800;         // of balls: 2,000 digits and more
constexpr long longest = 4'096;      // bits of a number in an element
constexpr long most_shifts = 40;     // primitive elements tried
constexpr long largest_order = 720;  // of a turn whose cosine is looked for

class Real {
  public:
    Real() {
        give_back_with_thread();
        arb_init(value_);
    }
    Real(const Real& other) : Real() { arb_set(value_, other.value_); }
    Real& operator=(const Real& other) {
        arb_set(value_, other.value_);
        return *this;
    }
    ~Real() { arb_clear(value_); }
    arb_ptr get() { return value_; }
    [[nodiscard]] arb_srcptr get() const { return value_; }

  private:
    arb_t value_;
};

class Fraction {
  public:
    Fraction() { fmpq_init(value_); }
    Fraction(const Fraction&) = delete;
    Fraction& operator=(const Fraction&) = delete;
    ~Fraction() { fmpq_clear(value_); }
    fmpq* get() { return value_; }

  private:
    fmpq_t value_;
};

class Whole {
  public:
    Whole() { fmpz_init(value_); }
    Whole(const Whole&) = delete;
    Whole& operator=(const Whole&) = delete;
    ~Whole() { fmpz_clear(value_); }
    fmpz* get() { return value_; }

  private:
    fmpz_t value_;
};

/// Over a field: lowest coefficient first.
using Over = std::vector<Polynomial>;

struct Stage {
    Polynomial modulus;  // monic, whole
    Real generator;
    Polynomial former;  // the generator of the stage before
};

Real value_at(const Polynomial& p, const Real& x) {
    Real sum, c;
    Fraction fraction;
    for (long i = p.degree(); i >= 0; --i) {
        fmpq_poly_get_coeff_fmpq(fraction.get(), p.get(), i);
        arb_set_fmpq(c.get(), fraction.get(), bits);
        arb_mul(sum.get(), sum.get(), x.get(), bits);
        arb_add(sum.get(), sum.get(), c.get(), bits);
    }
    return sum;
}

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
std::optional<Polynomial> vanishing_factor(const Polynomial& p, const Real& at) {
    fmpz_poly_t primitive;
    fmpz_poly_init(primitive);
    fmpq_poly_get_numerator(primitive, p.get());
    fmpz_poly_factor_t factors;
    fmpz_poly_factor_init(factors);
    fmpz_poly_factor(factors, primitive);
    std::optional<Polynomial> found;
    bool clear = true;
    for (long i = 0; i < factors->num; ++i) {
        Real value;
        arb_fmpz_poly_evaluate_arb(value.get(), factors->p + i, at.get(), bits);
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

struct NumberField::Inside {
    std::vector<Stage> stages;
    long order = 1;  // turns by multiples of 1/order have their cosines in the field
    Algebraic cosine{0, Polynomial(1)};  // of the smallest of them

    [[nodiscard]] const Stage& now() const { return stages.back(); }
    [[nodiscard]] Algebraic element(const Polynomial& p) const {
        if (p.bits() > longest) throw NotExact{"its numbers have too many digits"};
        return {static_cast<int>(stages.size()) - 1, remainder(p, now().modulus)};
    }
    [[nodiscard]] Polynomial lift(const Algebraic& a) const {
        if (a.value.is_rational()) return a.value;
        Polynomial p = a.value;
        for (std::size_t s = static_cast<std::size_t>(a.stage) + 1; s < stages.size(); ++s)
            p = composed(p, stages[s].former, stages[s].modulus);
        return p;
    }
    [[nodiscard]] Real value_of(const Algebraic& a) const {
        return value_at(lift(a), now().generator);
    }

    /// Of k times the smallest turn: T_k of its cosine.
    [[nodiscard]] Algebraic cosine_of(long k) const {
        const Polynomial x = lift(cosine);
        Polynomial before(1), value = k == 0 ? before : x;
        for (long i = 1; i < k; ++i) {
            const Polynomial next = remainder(x * value + x * value - before, now().modulus);
            before = value;
            value = next;
        }
        return element(value);
    }

    /// The root of g, a polynomial over the field of now, that lies in `ball` [Trager76].
    Algebraic adjoin(const Over& g, const Real& ball);
    Algebraic grow(const Over& g, const Real& ball, long shift, const Polynomial& minimal);
};

Algebraic NumberField::Inside::adjoin(const Over& g, const Real& ball) {
    const Stage stage = now();
    if (stage.modulus.degree() * (static_cast<long>(g.size()) - 1) > largest_norm)
        throw NotExact{"the number field is too large"};
    for (long shift = 0; shift < most_shifts; ++shift) {
        const Polynomial product = norm(stage.modulus, g, shift);
        if (!is_squarefree(product)) continue;
        Real sum;  // of the root and `shift` generators
        arb_mul_si(sum.get(), stage.generator.get(), shift, bits);
        arb_add(sum.get(), sum.get(), ball.get(), bits);
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

Algebraic NumberField::Inside::grow(const Over& g, const Real& ball, long shift,
                                    const Polynomial& minimal) {
    if (minimal.degree() > largest_degree) throw NotExact{"the number field is too large"};
    const Stage before = now();
    const Polynomial c = leading(minimal);
    Stage stage;
    stage.modulus = made_whole(minimal, c);
    arb_mul_si(stage.generator.get(), before.generator.get(), shift, bits);
    arb_add(stage.generator.get(), stage.generator.get(), ball.get(), bits);
    const Real scale = value_at(c, before.generator);
    arb_mul(stage.generator.get(), stage.generator.get(), scale.get(), bits);
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
    stages.push_back(stage);
    return element(reduce(gamma) - Polynomial(shift) * stage.former);
}

NumberField::NumberField() : inside_(std::make_unique<Inside>()) {
    Stage rationals;
    rationals.modulus = Polynomial::unknown();  // the generator is 0
    inside_->stages.push_back(rationals);
}
NumberField::~NumberField() = default;
NumberField::NumberField(NumberField&&) noexcept = default;
NumberField& NumberField::operator=(NumberField&&) noexcept = default;

Algebraic NumberField::add(const Algebraic& a, const Algebraic& b) const {
    return inside_->element(inside_->lift(a) + inside_->lift(b));
}

Algebraic NumberField::subtract(const Algebraic& a, const Algebraic& b) const {
    return inside_->element(inside_->lift(a) - inside_->lift(b));
}

Algebraic NumberField::multiply(const Algebraic& a, const Algebraic& b) const {
    return inside_->element(inside_->lift(a) * inside_->lift(b));
}

Algebraic NumberField::divide(const Algebraic& a, const Algebraic& b) const {
    const Polynomial& modulus = inside_->now().modulus;
    return inside_->element(inside_->lift(a) * inverse_modulo(inside_->lift(b), modulus));
}

Algebraic NumberField::square_root(const Algebraic& a) {
    const int side = sign(a);
    if (side < 0) throw NotExact{"the square root of a negative number"};
    if (side == 0) return whole(0);
    Real ball = inside_->value_of(a);
    arb_sqrt(ball.get(), ball.get(), bits);
    return inside_->adjoin({Polynomial(0) - inside_->lift(a), Polynomial(0), Polynomial(1)}, ball);
}

Algebraic NumberField::cosine(const Algebraic& degrees) {
    constexpr unsigned long full_turn = 360;
    if (!degrees.value.is_rational()) throw NotExact{"an angle of irrational degrees"};
    Fraction turns;
    fmpq_poly_get_coeff_fmpq(turns.get(), degrees.value.get(), 0);
    Whole all;
    fmpz_set_ui(all.get(), full_turn);
    fmpq_div_fmpz(turns.get(), turns.get(), all.get());
    const fmpz* order = fmpq_denref(turns.get());
    if (fmpz_cmp_si(order, largest_order) > 0) throw NotExact{"the number field is too large"};
    expect_turns(fmpz_get_si(order));
    fmpz_set_si(all.get(), inside_->order);
    fmpq_mul_fmpz(turns.get(), turns.get(), all.get());
    fmpz_fdiv_r(fmpq_numref(turns.get()), fmpq_numref(turns.get()), all.get());
    return inside_->cosine_of(fmpz_get_si(fmpq_numref(turns.get())));
}

void NumberField::expect_turns(long order) {
    const long together = std::lcm(order, inside_->order);
    if (together == inside_->order) return;
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
    Real ball;
    Fraction twice;
    fmpq_set_si(twice.get(), 2, static_cast<ulong>(together));
    arb_cos_pi_fmpq(ball.get(), twice.get(), bits);
    arb_mul_2exp_si(ball.get(), ball.get(), 1);
    const Algebraic doubled = inside_->adjoin(g, ball);
    Algebraic half{0, Polynomial(1)};
    fmpq_poly_scalar_div_si(half.value.get(), half.value.get(), 2);
    inside_->cosine = multiply(doubled, half);
    inside_->order = together;
}

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
    Real a, b, middle;
    arb_set_d(a.get(), low);
    arb_set_d(b.get(), high);
    const int below = arb_sgn_nonzero(value_at(of, a).get());
    if (below * arb_sgn_nonzero(value_at(of, b).get()) >= 0)
        throw NotExact{"no root is known there"};
    for (int i = 0; i < halvings; ++i) {
        arb_add(middle.get(), a.get(), b.get(), 2 * bits);
        arb_mul_2exp_si(middle.get(), middle.get(), -1);
        const int side = arb_sgn_nonzero(value_at(of, middle).get());
        if (side == 0) break;
        (side == below ? a : b) = middle;
    }
    arb_union(middle.get(), a.get(), b.get(), bits);
    return inside_->adjoin(g, middle);
}

int NumberField::sign(const Algebraic& a) const {
    if (a.value.is_zero()) return 0;
    const int side = arb_sgn_nonzero(inside_->value_of(a).get());
    if (side == 0) throw NotExact{"a sign that balls do not tell"};
    return side;
}

double NumberField::approximate(const Algebraic& a) const {
    return arf_get_d(arb_midref(inside_->value_of(a).get()), ARF_RND_NEAR);
}

Algebraic NumberField::lifted(const Algebraic& a) const {
    return inside_->element(inside_->lift(a));
}

long NumberField::degree() const { return inside_->now().modulus.degree(); }

const Polynomial& NumberField::minimal_polynomial() const { return inside_->now().modulus; }

}  // namespace pxm::host::exact
