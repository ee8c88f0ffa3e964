// How far a cell reaches in every direction from the eye, and which part of it eye rays can meet.
#pragma once

#include <array>

#include "host/compile/view.hpp"

namespace pxm::host {

/// An ellipsoid or a parallelepiped about a cell, in world units from the eye.
struct Extent {
    glm::dvec3 center{0.0};
    std::array<glm::dvec3, 3> half{};  // half axes, or half edges
    bool round = true;

    /// How far it reaches from its centre along a direction, times the direction's length.
    [[nodiscard]] double support(const glm::dvec3& direction) const;
    /// Of the ball about its centre that contains it.
    [[nodiscard]] double radius() const;
    /// The eye is at least that far away from it; 0 if it may be inside.
    [[nodiscard]] double distance() const;
};

/// Of the volume whose coordinates `linear` takes to the world, with the middle at `center`.
[[nodiscard]] Extent extent(const CompiledVolume& volume, const glm::dmat3& linear,
                            const glm::dvec3& center);

/// A point of a volume's coordinates that its extent is about.
[[nodiscard]] glm::dvec3 middle(const CompiledVolume& volume);

/// What rays from the eye can reach.
class Frustum {
  public:
    Frustum(const View& view, const PixelSize& size);
    /// `bulge`: how much larger than the extent something may be that they meet.
    [[nodiscard]] bool misses(const Extent& extent, double bulge) const;

  private:
    std::array<glm::dvec3, 5> inward_;  // normals of the planes through the eye
};

}  // namespace pxm::host
