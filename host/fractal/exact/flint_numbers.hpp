// Numbers of FLINT and Arb that own their memory: whole numbers, fractions, and real numbers known
// in balls of 2,000 digits, which tell the signs of a number field's elements.
#pragma once

#include <arb.h>
#include <flint/fmpq.h>
#include <flint/fmpz.h>

#include "host/fractal/exact/thread_memory.hpp"

namespace pxm::host::exact {

inline constexpr long long_bits = 6'800;  // of a LongReal: 2,000 digits and more

class LongReal {
  public:
    LongReal() {
        give_back_with_thread();
        arb_init(value_);
    }
    LongReal(const LongReal& other) : LongReal() { arb_set(value_, other.value_); }
    LongReal& operator=(const LongReal& other) {
        arb_set(value_, other.value_);
        return *this;
    }
    ~LongReal() { arb_clear(value_); }
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

}  // namespace pxm::host::exact
