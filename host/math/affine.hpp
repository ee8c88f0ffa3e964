// Affine maps in double, in the thesis' convention: row vectors, x' = x T + a (Sec. 6.2).
// T is kept in a glm matrix whose glm *column* i is the thesis' *row* i, so that glm's `T * x`
// is the thesis' `x T`, and "first A, then B" (x A B) is `B.linear * A.linear`.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace pxm::host {

/// x' = x T + a. Default: the identity.
struct Affine {
    glm::dmat3 linear{1.0};       // T; linear[i] is row i of the thesis' matrix
    glm::dvec3 translation{0.0};  // a, row 4 of the thesis' matrix

    /// The image of a point.
    [[nodiscard]] glm::dvec3 point(const glm::dvec3& x) const { return linear * x + translation; }
    /// The image of a direction.
    [[nodiscard]] glm::dvec3 direction(const glm::dvec3& d) const { return linear * d; }
    bool operator==(const Affine&) const = default;
};

/// The map that applies `first` and then `second` (the thesis' product `first second`).
[[nodiscard]] inline Affine then(const Affine& first, const Affine& second) {
    return {second.linear * first.linear, second.point(first.translation)};
}

/// The inverse map. Precondition: det T is not zero.
[[nodiscard]] Affine inverse(const Affine& map);

/// Determinant of the linear part.
[[nodiscard]] double determinant(const Affine& map);

/// Canonical maps of the scene language. Angles in degrees: z turns +x toward +y, x turns +y
/// toward +z, y turns +z toward +x.
[[nodiscard]] Affine scaling(const glm::dvec3& factors);
[[nodiscard]] Affine translation(const glm::dvec3& offset);  // x + offset
enum class Axis { x, y, z };                                 // of space
[[nodiscard]] Affine rotation(Axis axis, double degrees);    // about an axis through 0

}  // namespace pxm::host
