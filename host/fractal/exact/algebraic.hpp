// An element of a number field, and what there is in its place where exact numbers are out of
// reach.
#pragma once

#include <string>

#include "host/fractal/exact/polynomial.hpp"

namespace pxm::host::exact {

/// An element of a field, in the generator that the field had at `stage`.
struct Algebraic {
    int stage = 0;
    Polynomial value;
};

/// The field would be too large, or a number is in no field: pi.
struct NotExact {
    std::string why;
};

[[nodiscard]] inline Algebraic whole(long value) { return {0, Polynomial(value)}; }

}  // namespace pxm::host::exact
