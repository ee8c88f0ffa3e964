// Real numbers of which is known that they lie in balls of certified radius (Arb), where no number
// field of moderate size has them. What balls decide is proven; that two numbers are equal they
// never decide.
#pragma once

#include <arb.h>

#include <array>
#include <string>
#include <utility>

#include "host/fractal/exact/thread_memory.hpp"

namespace pxm::host::exact {

inline constexpr slong ball_bits = 220;  // of a middle: 66 digits

class RealBall {
  public:
    RealBall() {
        give_back_with_thread();
        arb_init(value_);
    }
    explicit RealBall(long whole) : RealBall() { arb_set_si(value_, whole); }
    RealBall(const RealBall& other) : RealBall() { arb_set(value_, other.value_); }
    RealBall(RealBall&& other) noexcept : RealBall() { arb_swap(value_, other.value_); }
    RealBall& operator=(RealBall other) noexcept {
        arb_swap(value_, other.value_);
        return *this;
    }
    ~RealBall() { arb_clear(value_); }

    [[nodiscard]] static RealBall of_double(double middle, double radius);
    [[nodiscard]] static RealBall decimal(const std::string& text);
    [[nodiscard]] static RealBall pi();

    [[nodiscard]] arb_ptr get() { return value_; }
    [[nodiscard]] arb_srcptr get() const { return value_; }
    [[nodiscard]] double middle() const;
    [[nodiscard]] double radius() const;  // rounded up
    /// No number of the ball is nearer to 0, and none is further from it.
    [[nodiscard]] double least() const;
    [[nodiscard]] double most() const;
    /// Above the distance of `x` from all numbers of the ball.
    [[nodiscard]] double farthest_from(double x) const;
    [[nodiscard]] bool is_zero() const { return arb_is_zero(value_) != 0; }
    [[nodiscard]] bool is_positive() const { return arb_is_positive(value_) != 0; }
    [[nodiscard]] bool is_negative() const { return arb_is_negative(value_) != 0; }

  private:
    arb_t value_;
};

[[nodiscard]] RealBall operator+(const RealBall& a, const RealBall& b);
[[nodiscard]] RealBall operator-(const RealBall& a, const RealBall& b);
[[nodiscard]] RealBall operator*(const RealBall& a, const RealBall& b);
[[nodiscard]] RealBall operator/(const RealBall& a, const RealBall& b);
[[nodiscard]] RealBall magnitude(const RealBall& a);
/// Of what is not negative, else of nothing known.
[[nodiscard]] RealBall square_root(const RealBall& a);
[[nodiscard]] RealBall sine(const RealBall& degrees);
[[nodiscard]] RealBall cosine(const RealBall& degrees);

/// x -> A x + a: rows of A, each with its entry of a at the end.
using BallEntries = std::array<std::array<RealBall, 4>, 3>;

/// First `inner`, then `outer`.
[[nodiscard]] BallEntries composed(const BallEntries& outer, const BallEntries& inner);

}  // namespace pxm::host::exact
