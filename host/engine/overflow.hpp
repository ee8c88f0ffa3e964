// Whether a result was too large for its numbers: the sticky flags of the arithmetic units, read
// by the host when a pixel is finished. A division by zero counts, as it does on the DSP32, whose
// reciprocal of 0 saturates.
#pragma once

#include <cfenv>
#include <concepts>
#include <utility>

#include "pxm/dsp32/float.hpp"

namespace pxm::host {

/// Whether a result of this thread was beyond the range of Real since the last call.
template <class Real>
[[nodiscard]] bool take_overflow() noexcept {
    if constexpr (std::same_as<Real, dsp32::Float>) {
        return std::exchange(dsp32::overflowed, false);
    } else {
        constexpr int beyond = FE_OVERFLOW | FE_DIVBYZERO;
        if (std::fetestexcept(beyond) == 0) return false;
        std::feclearexcept(beyond);
        return true;
    }
}

/// Forgets what this thread computed before.
inline void clear_overflow() noexcept {
    dsp32::overflowed = false;
    std::feclearexcept(FE_OVERFLOW | FE_DIVBYZERO);
}

}  // namespace pxm::host
