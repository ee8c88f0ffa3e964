// Lipschitz constants of affine maps (Ch. 16), in double, and what goes with the singular values.
#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "host/math/affine.hpp"

namespace pxm::host {

/// T = U diag(values) V^T, values falling. In row-vector terms x T: see lipschitz.cpp.
struct SingularValues {
    std::array<double, 3> values;      // largest first
    std::array<glm::dvec3, 3> input;   // unit: direction that is stretched by values[i] ...
    std::array<glm::dvec3, 3> output;  // ... and its image's unit direction: x T
};
[[nodiscard]] SingularValues singular_values(const glm::dmat3& linear);  // of the linear part

/// The largest singular value: Lip w by polar decomposition (Sec. 16.2).
[[nodiscard]] double lipschitz_constant(const Affine& map);
/// The smallest singular value.
[[nodiscard]] double smallest_singular_value(const Affine& map);
/// The cube root of |det T|, a lower bound (Eq. 16.3, erratum 6).
[[nodiscard]] double determinant_constant(const Affine& map);

/// The narrowest kind that a map is of.
enum class MapKind { homothety, similitude, affine, singular };
/// homothety: uniform scale and translation; similitude: with rotation or reflection;
/// singular: smallest singular value below 1e-12 of the largest.
[[nodiscard]] MapKind classify(const Affine& map);

/// The map with each vanishing singular value (below 1e-12 of the largest, or of 1 for the zero
/// map) raised to `thickness`, so that it has an inverse. A regular map is returned unchanged.
[[nodiscard]] Affine lift(const Affine& map, double thickness);

}  // namespace pxm::host
