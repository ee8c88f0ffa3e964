#include "host/compile/filled_volume.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "host/compiled/bounding_volume.hpp"
#include "host/fractal/bounds/filled.hpp"

namespace pxm::host {

namespace {

constexpr double same = 1e-6;        // angle, as good as none
constexpr double margin = 1e-9;      // of the size, as bounds have it
constexpr double sheet = 1.0 / 512;  // of a polygon's size: how thick its volume is

bool is_axis(const glm::dvec3& u) {
    return std::max({std::abs(u.x), std::abs(u.y), std::abs(u.z)}) > 1 - same * same;
}

bool is_box(const ConvexHull& hull) {
    return std::ranges::all_of(hull.faces,
                               [](const HullFace& face) { return is_axis(face.normal); });
}

double reach_of(const Points& points, const glm::dvec3& u) {
    double reach = glm::dot(points.front(), u);
    for (const glm::dvec3& point : points) reach = std::max(reach, glm::dot(point, u));
    return reach;
}

/// The directions of a polygon's edges' normals, in its plane.
std::vector<glm::dvec3> edge_normals(const ConvexHull& hull, const glm::dvec3& across) {
    std::vector<glm::dvec3> normals;
    for (const HullFace& face : hull.faces) {
        if (std::abs(glm::dot(face.normal, across)) < 0.5) normals.push_back(face.normal);
    }
    return normals;
}

bool is_rectangle(const std::vector<glm::dvec3>& normals) {
    return normals.size() == 4 && std::ranges::all_of(normals, [&](const glm::dvec3& normal) {
               const double cosine = std::abs(glm::dot(normal, normals[0]));
               return cosine < same || cosine > 1 - same;
           });
}

/// A box around a rectangle, along its sides.
CompiledVolume rectangle_volume(const Points& corners, const glm::dmat3& axes, double thickness,
                                double room) {
    glm::dvec3 low, high;
    for (int i = 0; i < 3; ++i) {
        low[i] = -reach_of(corners, -axes[i]) - room;
        high[i] = reach_of(corners, axes[i]) + room;
    }
    const double middle = (low.z + high.z) / 2;
    low.z = middle - thickness / 2;
    high.z = middle + thickness / 2;
    const OrientedBox box = oriented_box(axes, low, high);
    if (!is_axis(axes[0]) || !is_axis(axes[2])) return oriented_volume(box);
    const glm::dvec3 half = glm::abs(box.half[0]) + glm::abs(box.half[1]) + glm::abs(box.half[2]);
    return box_volume(box.center - half, box.center + half);
}

/// The polygon is thick in `hull`, as it is seen from there.
CompiledVolume polygon_volume(const ConvexHull& hull, const glm::dvec3& across,
                              const glm::dvec3& center) {
    Points corners = hull.corners;
    const double middle = (reach_of(corners, across) - reach_of(corners, -across)) / 2;
    for (glm::dvec3& corner : corners) corner += (middle - glm::dot(corner, across)) * across;
    double size = 0;
    for (const glm::dvec3& corner : corners) {
        size = std::max(size, glm::distance(corner, corners.front()));
    }
    const double room = margin * size;
    const std::vector<glm::dvec3> normals = edge_normals(hull, across);
    if (is_rectangle(normals)) {
        const glm::dmat3 axes{normals[0], glm::cross(across, normals[0]), across};
        return rectangle_volume(corners, axes, sheet * size, room);
    }
    Polytope sides{{across, middle + sheet * size / 2}, {-across, -middle + sheet * size / 2}};
    for (const glm::dvec3& normal : normals) {
        sides.push_back({normal, reach_of(corners, normal) + room});
    }
    return hull_volume(sides, center);
}

/// The computed hull, cut to what the surface is seen as.
CompiledVolume surface_volume(const CompiledVolume& computed, const ConvexHull& seen,
                              const glm::dvec3& along) {
    Polytope sides = computed.half_spaces;
    double size = 0;
    for (const glm::dvec3& corner : seen.corners) {
        size = std::max(size, glm::distance(corner, seen.corners.front()));
    }
    for (const glm::dvec3& normal : edge_normals(seen, along)) {
        const bool known = std::ranges::any_of(sides, [&](const HalfSpace& side) {
            return glm::dot(side.normal, normal) > 1 - same * same;
        });
        if (known || sides.size() == most_half_spaces) continue;
        sides.push_back({normal, reach_of(seen.corners, normal) + margin * size});
    }
    return hull_volume(sides, computed.center);
}

}  // namespace

std::optional<std::vector<CompiledVolume>> filled_volumes(const Rifs& rifs,
                                                          const std::vector<Bounds>& bounds,
                                                          VolumeComputer& computer) {
    const Filled filled = find_filling(rifs);
    if (filled.filling == Filling::none) return std::nullopt;
    const bool boxes =
        filled.filling == Filling::solid && std::ranges::all_of(filled.hulls, is_box);
    std::vector<CompiledVolume> volumes;
    for (std::size_t set = 0; set < bounds.size(); ++set) {
        const ConvexHull& hull = filled.hulls[set];
        if (filled.filling == Filling::polygon) {
            volumes.push_back(polygon_volume(hull, filled.across[set], bounds[set].ball.center));
        } else if (filled.filling == Filling::surface) {
            volumes.push_back(surface_volume(computer.hull(set), hull, filled.across[set]));
        } else {
            volumes.push_back(boxes ? computer.box(set) : computer.hull(set));
        }
    }
    return volumes;
}

}  // namespace pxm::host
