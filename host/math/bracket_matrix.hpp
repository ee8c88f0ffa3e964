// Linear parts of maps and of words in brackets, and a bound of their norm that rounding cannot
// spoil: what proofs of contraction and of volumes are made of.
#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "host/math/bracket.hpp"

namespace pxm::host {

using BracketVector = std::array<Bracket, 3>;

/// A matrix in glm's order, as Affine::linear has it: [column][row].
struct BracketMatrix {
    std::array<BracketVector, 3> column;

    BracketMatrix() = default;  // zero
    explicit BracketMatrix(const glm::dmat3& matrix);
    const BracketVector& operator[](int i) const { return column[static_cast<std::size_t>(i)]; }
    BracketVector& operator[](int i) { return column[static_cast<std::size_t>(i)]; }
};

[[nodiscard]] BracketMatrix operator*(const BracketMatrix& a, const BracketMatrix& b);
[[nodiscard]] BracketVector operator*(const BracketMatrix& a, const BracketVector& x);
[[nodiscard]] BracketVector operator+(const BracketVector& a, const BracketVector& b);
[[nodiscard]] BracketVector operator-(const BracketVector& a, const BracketVector& b);
[[nodiscard]] BracketVector bracket(const glm::dvec3& x);

/// The length of a vector.
[[nodiscard]] Bracket length(const BracketVector& x);

/// The inverse of a lower triangular matrix (glm's [column][row] is 0 for row < column).
[[nodiscard]] BracketMatrix inverse_of_lower(const glm::dmat3& lower);

/// No smaller than the largest singular value of any matrix in `matrix`, and larger than it by
/// little more than the brackets are wide; infinite where double cannot tell.
[[nodiscard]] double norm_at_most(const BracketMatrix& matrix);
[[nodiscard]] double norm_at_most(const glm::dmat3& matrix);

}  // namespace pxm::host
