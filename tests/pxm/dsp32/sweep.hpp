// The accuracies stated in pxm/dsp32/routines.hpp and docs/arithmetic.md, measured on mantissas at
// a stride: both signs for the reciprocal, even and odd exponents for the roots.
#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "pxm/dsp32/routines.hpp"
#include "pxm/dsp32/trigonometry.hpp"
#include "tests/pxm/dsp32/random_words.hpp"

namespace pxm::dsp32::routines {

/// The largest error met by a routine.
class Worst {
  public:
    void relative(Word got, long double exact) {
        error_ = std::max(error_, std::abs((double_of(got) - exact) / exact));
    }
    void absolute(Float got, long double exact) {
        error_ = std::max(error_, std::abs(to_double(got) - exact));
    }
    [[nodiscard]] double error() const { return static_cast<double>(error_); }

  private:
    long double error_ = 0;
};

inline void sweep_reciprocals(Word stride) {
    Worst quick, full, quotient_quick, quotient;
    for (Word field = 0; field < (1U << 24); field += stride) {
        const Word y = field << 8 | exponent_bias;
        const long double value = double_of(y);
        quick.relative(reciprocal_quick(y), 1 / value);
        full.relative(reciprocal(y), 1 / value);
        const Word x = (field * 2654435761U) << 8 | exponent_bias;  // another mantissa, scattered
        quotient_quick.relative(divide_quick(x, y), double_of(x) / value);
        quotient.relative(divide(x, y), double_of(x) / value);
    }
    EXPECT_LT(quick.error(), 1.8e-6);
    EXPECT_LT(full.error(), 6.0e-8);
    EXPECT_LT(quotient_quick.error(), 2.0e-6);
    EXPECT_LT(quotient.error(), 6.0e-8);
}

inline void sweep_roots(Word stride) {
    Worst quick, full, reciprocal;
    for (Word field = 0; field < (1U << 23); field += stride) {
        for (const Word exponent : {128U, 129U}) {
            const Word x = field << 8 | exponent;
            const long double root = std::sqrt(static_cast<long double>(double_of(x)));
            quick.relative(square_root_quick(x), root);
            full.relative(square_root(x), root);
            reciprocal.relative(reciprocal_square_root(x), 1 / root);
        }
    }
    EXPECT_LT(quick.error(), 3.0e-5);
    EXPECT_LT(full.error(), 6.2e-8);
    EXPECT_LT(reciprocal.error(), 9.0e-8);
}

inline void sweep_sines(Word stride) {
    Worst sines, cosines;
    for (Word field = 0; field < (1U << 24); field += stride) {
        const Float x{(static_cast<double>(field) - 0x1p23) * (100 * M_PI / 0x1p23)};
        const long double value = to_double(x);
        sines.absolute(sine(x), std::sin(value));
        cosines.absolute(cosine(x), std::cos(value));
    }
    EXPECT_LT(sines.error(), 1.2e-7);
    EXPECT_LT(cosines.error(), 1.2e-7);
}

inline void sweep_mantissas(Word stride) {
    sweep_reciprocals(stride);
    sweep_roots(stride);
    sweep_sines(stride);
}

}  // namespace pxm::dsp32::routines
