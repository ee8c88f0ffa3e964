// Convex polytopes of few corners, by trying all planes through three of them: the open sets that
// are tried for the open-set condition (Def. 3.9).
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "host/fractal/bounds/inner_points.hpp"
#include "host/math/affine.hpp"

namespace pxm::host {

/// The side normal . x <= offset; the normal is a unit vector.
struct HullFace {
    glm::dvec3 normal{0.0};
    double offset = 0;
};

struct ConvexHull {
    Points corners;
    std::vector<HullFace> faces;

    /// Up to `tolerance`, a length.
    [[nodiscard]] bool contains(const glm::dvec3& point, double tolerance) const;
};

inline constexpr std::size_t most_corners = 40;

/// The convex hull. Nothing if it is flat to within `tolerance` (a length) or has too many corners.
[[nodiscard]] std::optional<ConvexHull> convex_hull(const Points& points, double tolerance);

/// The points, and where they lie in a plane, on a line or at a point, each of them moved to both
/// sides by `thickness`, so that their hull has an inside.
[[nodiscard]] Points thickened(const Points& points, double tolerance, double thickness);

/// True if a plane was found between the images of two polytopes: their insides do not meet.
[[nodiscard]] bool separated(const ConvexHull& a, const Affine& image_a, const ConvexHull& b,
                             const Affine& image_b, double tolerance);

}  // namespace pxm::host
