// The solid that stands for a cell, asked how far away its surface is: a ball, a box, or what flat
// faces bound. A ball that is squashed is an ellipsoid.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <variant>
#include <vector>

#include "host/export/mesh.hpp"
#include "host/math/affine.hpp"

namespace pxm::host {

struct Box3 {
    glm::dvec3 low{0.0};
    glm::dvec3 high{0.0};
};

/// The kinds of them.
namespace solids {

struct Ball {
    glm::dvec3 center{0.0};
    double radius = 0;
};
struct Ellipsoid {
    glm::dvec3 center{0.0};
    glm::dmat3 axes{1.0};  // of the unit ball
    glm::dmat3 back{1.0};  // to it
    double thinnest = 0;   // half of the least width
};
struct Box {
    glm::dvec3 center{0.0};
    glm::dmat3 axes{1.0};  // columns of length 1
    glm::dvec3 half{0.0};
};
struct Face {
    glm::dvec3 normal{0.0};  // outward, of length 1
    double offset = 0;
    std::vector<glm::dvec3> corners;
};
struct Polytope {
    std::vector<Face> faces;
    std::vector<glm::dvec3> corners;
};

}  // namespace solids

class Solid {
  public:
    /// A volume and the image of it; `shape` is the surface of the volume, which is convex.
    Solid(const CompiledVolume& volume, const Mesh& shape, const Affine& place = {});

    /// The distance to the surface, negative inside; exact up to `reach`, and no less than that
    /// beyond. Of an ellipsoid its sign is exact, and its size to first order near the surface.
    [[nodiscard]] double distance(const glm::dvec3& x, double reach) const;
    /// Of the distance's sign, and no larger in magnitude; as large, but of an ellipsoid.
    [[nodiscard]] double at_least(const glm::dvec3& x, double reach) const;
    /// A box around the image of the solid, along the axes.
    [[nodiscard]] Box3 extent(const Affine& place) const;

  private:
    std::variant<solids::Ball, solids::Ellipsoid, solids::Box, solids::Polytope> form_;
};

}  // namespace pxm::host
