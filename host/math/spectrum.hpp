// Eigenvalues by Eigen's iterations, which may give up: then there is nothing, never the numbers
// that stood where a result would.
#pragma once

#include <glm/mat3x3.hpp>
#include <optional>

namespace pxm::host {

/// The largest absolute eigenvalue, as computed. Nothing for what is not finite.
[[nodiscard]] std::optional<double> spectral_radius(const glm::dmat3& matrix);

/// Unit eigenvectors, those of the largest eigenvalue first. Nothing for what is not finite.
/// Precondition: the matrix is symmetric.
[[nodiscard]] std::optional<glm::dmat3> symmetric_axes(const glm::dmat3& matrix);

/// The largest rho with a x = rho b x for an x that is not 0, as computed. Nothing unless b is
/// positive definite, as far as double can tell. Precondition: both are symmetric.
[[nodiscard]] std::optional<double> largest_ratio(const glm::dmat3& a, const glm::dmat3& b);

/// L, lower triangular, with L L^T = matrix up to rounding. Nothing unless the matrix is positive
/// definite, as far as double can tell. Precondition: it is symmetric.
[[nodiscard]] std::optional<glm::dmat3> lower_root(const glm::dmat3& matrix);

}  // namespace pxm::host
