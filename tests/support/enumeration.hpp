// The attractor without rays: its cells are subdivided down to a quarter of a pixel and projected
// into the image. Uses the maps, the graph and the camera alone; bounding volumes play no part.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "host/compiled/compiled_scene.hpp"

namespace pxm::test {

/// A point within a quarter of a pixel of the attractor, and where it is seen.
struct AttractorPoint {
    glm::dvec3 place{0.0};  // scene units, the eye at the origin
    double depth = 0;       // distance from the eye; orthographic: from the eye's plane
    int object = 0;
};

/// Where a point of the scene falls in the image, in pixels: pixel (x, y) covers [x, x+1) x [y,
/// y+1). Nothing if it lies behind the eye.
struct ImagePlace {
    double x = 0;
    double y = 0;
};
[[nodiscard]] std::optional<ImagePlace> project(const host::CompiledCamera& camera,
                                                const glm::dvec3& point);

/// The points of all objects, sorted into the pixels that they fall in. Precondition: every map
/// contracts, no object has a `levels`, and the eye is outside of the objects.
class Enumeration {
  public:
    explicit Enumeration(const host::CompiledScene& scene);

    /// What falls into a pixel; empty outside of the image.
    [[nodiscard]] const std::vector<AttractorPoint>& at(long x, long y) const;
    [[nodiscard]] long points() const { return points_; }
    /// The smallest distance from `place` to a point that falls within `reach` pixels of (x, y).
    [[nodiscard]] double distance(const glm::dvec3& place, long x, long y, long reach) const;

  private:
    void subdivide(int object, const host::Affine& place, double lip, int set);
    [[nodiscard]] double pixel_size(const glm::dvec3& place) const;

    const host::CompiledScene& scene_;
    /// Per shape and follow set: a ball that contains what may stand there, found by iterating the
    /// maps on the balls themselves.
    struct Ball {
        glm::dvec3 center{0.0};
        double radius = 0;
    };
    [[nodiscard]] static std::vector<Ball> balls_of(const host::CompiledShape& shape);

    std::vector<std::vector<Ball>> balls_;
    std::vector<std::vector<AttractorPoint>> pixels_;
    std::vector<AttractorPoint> nothing_;
    long points_ = 0;
};

/// `count` points of an object's attractor, exact up to rounding: images of a fixed point under
/// random admissible words (seeded).
[[nodiscard]] std::vector<glm::dvec3> random_points(const host::CompiledScene& scene, int object,
                                                    int count, unsigned seed);

}  // namespace pxm::test
