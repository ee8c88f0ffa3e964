// The affine hull of an attractor: the point, line, plane or space that it lies in. What maps do in
// directions in which the attractor does not extend says nothing of it.
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "host/fractal/system/rifs.hpp"

namespace pxm::host {

/// point + span of the first `dimension` axes, which are orthonormal.
struct AffineHull {
    glm::dvec3 point{0.0};             // one of it
    int dimension = 0;                 // 0 to 3
    std::array<glm::dvec3, 3> axes{};  // all three, also those beyond the dimension
};

/// point, line, plane or space
[[nodiscard]] constexpr const char* hull_name(int dimension) {
    constexpr std::array names{"point", "line", "plane", "space"};
    return names[static_cast<std::size_t>(dimension)];
}

/// Of each E_s, up to rounding: what sticks out by less than 1e-11 of the maps and of the places
/// does not count. Precondition: the system contracts.
[[nodiscard]] std::vector<AffineHull> affine_hulls(const Rifs& rifs);

/// The same, and how often an edge of the graph (a map in a follow set) was looked at for it.
struct HullSearch {
    std::vector<AffineHull> hulls;    // of each E_s
    std::size_t edges_looked_at = 0;  // each time
};
/// As affine_hulls().
[[nodiscard]] HullSearch search_affine_hulls(const Rifs& rifs);

/// By how much a map stretches lengths, areas or volumes (as many as the hull has dimensions) of
/// what lies in `hull`; 1 for a point.
[[nodiscard]] double stretch_within(const AffineHull& hull, const Affine& map);

/// The same maps in coordinates of the hulls: the linear part of a map takes the hull of what
/// stands inside it to that of where it stands, first axes first, and all other entries are exactly
/// 0. Translations are left out. Nothing if a map stands in hulls of different directions.
[[nodiscard]] std::optional<Rifs> within_hulls(const Rifs& rifs,
                                               const std::vector<AffineHull>& hulls);

/// Where all maps are similitudes of the hulls, the same system by similitudes of space: what maps
/// did beside the hulls never mattered. Else `rifs` itself.
[[nodiscard]] Rifs as_similitudes(const Rifs& rifs, const std::vector<AffineHull>& hulls);

/// The largest dimension of the hulls of sets that a cycle passes: no part of the attractor has
/// more dimensions.
[[nodiscard]] int recurrent_dimension(const Rifs& rifs, const std::vector<AffineHull>& hulls);

}  // namespace pxm::host
