// How a proven bound is printed: six digits, and never less than it is.
#pragma once

#include <string>

namespace pxm::host {

/// x to six digits, rounded up (rounding of x itself, below 1e-13 of it, is no reason to).
[[nodiscard]] std::string six_digits_above(double x);

}  // namespace pxm::host
