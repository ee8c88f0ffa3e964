// Attractors that are surfaces and solids known exactly: where a ray first comes to them and which
// way they face there follows from school geometry. No cell, volume or map has a part in it, so
// they judge the definition of the picture as well as the engines.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/fractal/bounds/polytope.hpp"
#include "tests/support/oracle.hpp"

namespace pxm::test {

/// Where a ray first comes to a surface.
struct SurfaceHit {
    double depth = 0;        // along the ray
    glm::dvec3 normal{0.0};  // a unit vector towards the ray's origin
};

/// The points of a graph z = xx x^2 + xy x y + yy y^2 + x x + constant, or, without one, of space,
/// that lie within all the sides.
struct KnownSurface {
    struct Graph {
        double xx = 0, xy = 0, yy = 0, x = 0;
    };
    std::string name;  // letters and underscores: also the name of a test
    std::string maps;  // of the ifs block whose attractor it is
    std::optional<Graph> graph;
    std::vector<host::HalfSpace> sides;

    [[nodiscard]] bool is_curved() const;
    /// Where a ray first comes to it, all sides moved outwards by `grown` first.
    [[nodiscard]] std::optional<SurfaceHit> hit(const Sight& ray, double grown = 0) const;
    /// How far a point is from the surface, at least.
    [[nodiscard]] double distance(const glm::dvec3& point) const;
};

/// Planes, squares and triangles, z = x y, z = x^2 + y^2, and solids with flat faces: a cube, a
/// prism, a simplex, and the wedge 0 <= z <= 1, z <= y <= x <= 2 (of half that size).
[[nodiscard]] std::vector<KnownSurface> known_surfaces();
/// The one of that name.
[[nodiscard]] KnownSurface known_surface(const std::string& name);

}  // namespace pxm::test
