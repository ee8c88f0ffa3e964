#include "host/fractal/exact/real_ball.hpp"

#include <algorithm>
#include <cmath>

namespace pxm::host::exact {

namespace {

constexpr long half_turn = 180;  // degrees

/// Sets a bound from an Arb function that takes (arf, arb) and rounds it as told.
template <class Bound>
double bound_of(arb_srcptr value, Bound bound, arf_rnd_t rounding) {
    arf_t x;
    arf_init(x);
    bound(x, value);
    const double result = arf_get_d(x, rounding);
    arf_clear(x);
    return result;
}

}  // namespace

RealBall RealBall::of_double(double middle, double radius) {
    RealBall ball;
    arb_set_d(ball.value_, middle);
    mag_t more;
    mag_init(more);
    mag_set_d(more, radius);
    arb_add_error_mag(ball.value_, more);
    mag_clear(more);
    return ball;
}

RealBall RealBall::decimal(const std::string& text) {
    RealBall ball;
    if (arb_set_str(ball.value_, text.c_str(), ball_bits) != 0) arb_indeterminate(ball.value_);
    return ball;
}

RealBall RealBall::pi() {
    RealBall ball;
    arb_const_pi(ball.value_, ball_bits);
    return ball;
}

double RealBall::middle() const { return arf_get_d(arb_midref(value_), ARF_RND_NEAR); }

double RealBall::radius() const { return mag_get_d(arb_radref(value_)) * (1 + 0x1p-50); }

double RealBall::least() const {
    return bound_of(
        value_, [](arf_t to, arb_srcptr of) { arb_get_abs_lbound_arf(to, of, ball_bits); },
        ARF_RND_FLOOR);
}

double RealBall::most() const {
    return bound_of(
        value_, [](arf_t to, arb_srcptr of) { arb_get_abs_ubound_arf(to, of, ball_bits); },
        ARF_RND_CEIL);
}

double RealBall::farthest_from(double x) const { return (*this - of_double(x, 0)).most(); }

RealBall operator+(const RealBall& a, const RealBall& b) {
    RealBall result;
    arb_add(result.get(), a.get(), b.get(), ball_bits);
    return result;
}

RealBall operator-(const RealBall& a, const RealBall& b) {
    RealBall result;
    arb_sub(result.get(), a.get(), b.get(), ball_bits);
    return result;
}

RealBall operator*(const RealBall& a, const RealBall& b) {
    RealBall result;
    arb_mul(result.get(), a.get(), b.get(), ball_bits);
    return result;
}

RealBall operator/(const RealBall& a, const RealBall& b) {
    RealBall result;
    arb_div(result.get(), a.get(), b.get(), ball_bits);
    return result;
}

RealBall magnitude(const RealBall& a) {
    RealBall result;
    arb_abs(result.get(), a.get());
    return result;
}

RealBall square_root(const RealBall& a) {
    RealBall result;
    arb_sqrt(result.get(), a.get(), ball_bits);
    return result;
}

RealBall sine(const RealBall& degrees) {
    RealBall result = degrees / RealBall(half_turn);
    arb_sin_pi(result.get(), result.get(), ball_bits);
    return result;
}

RealBall cosine(const RealBall& degrees) {
    RealBall result = degrees / RealBall(half_turn);
    arb_cos_pi(result.get(), result.get(), ball_bits);
    return result;
}

BallEntries composed(const BallEntries& outer, const BallEntries& inner) {
    BallEntries result;
    for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t c = 0; c < 4; ++c) {
            RealBall& sum = result[r][c];
            if (c == 3) sum = outer[r][3];
            for (std::size_t k = 0; k < 3; ++k)
                arb_addmul(sum.get(), outer[r][k].get(), inner[k][c].get(), ball_bits);
        }
    return result;
}

}  // namespace pxm::host::exact
