// What rounding may take from a sum of a few products: the a-priori error of double, to nearest.
// Where brackets (bracket.hpp) would cost a search its speed, a number is computed as ever and its
// error is carried beside it.
#pragma once

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "host/math/bracket.hpp"

namespace pxm::host {

/// A sum of products in which no number passes more than twelve operations is off by no more than
/// that share of the sum of absolute values: n u / (1 - n u) for n = 12, u = 2^-53 [Higham02], and
/// room for the rounding of that sum itself.
inline constexpr double few_roundings = 0x1p-49;

/// What numbers below the smallest may take from the same sum, whatever its terms.
inline constexpr double underflow = 0x1p-1040;

/// What a sum of a few products may be off by, from the sum of absolute values.
[[nodiscard]] inline double rounding_of(double magnitudes) {
    return few_roundings * magnitudes + underflow;
}

/// |x| + |y| + |z|
[[nodiscard]] inline double sum_of_parts(const glm::dvec3& u) {
    return std::abs(u.x) + (std::abs(u.y) + std::abs(u.z));
}

/// |x| |y|, no smaller than |x . y|.
[[nodiscard]] inline double dot_of_parts(const glm::dvec3& x, const glm::dvec3& y) {
    return glm::dot(glm::abs(x), glm::abs(y));
}

/// The sizes of the terms of `linear` * x + a, one sum a coordinate.
[[nodiscard]] inline glm::dvec3 terms_of(const glm::dmat3& linear, const glm::dvec3& x,
                                         const glm::dvec3& a) {
    const glm::dvec3 size = glm::abs(x);
    return glm::abs(linear[0]) * size.x + glm::abs(linear[1]) * size.y +
           glm::abs(linear[2]) * size.z + glm::abs(a);
}

/// A computed number, and a bound of what the real one may be more for rounding.
struct Rounded {
    double value = 0;     // as double computes it
    double rounding = 0;  // what the real number may be more, not negative
    /// No smaller than the real number.
    [[nodiscard]] double at_most() const { return above(value + rounding); }
};

}  // namespace pxm::host
