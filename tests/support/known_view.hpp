// Known surfaces in a view, and a picture of one judged by what is known of it.
#pragma once

#include <glm/mat3x3.hpp>
#include <string>

#include "host/engine/engine.hpp"
#include "tests/support/known_surface.hpp"

namespace pxm::test {

/// Where a surface is seen from, in its own coordinates, and how it is turned in the world.
struct KnownView {
    std::string name;
    glm::dvec3 eye{0.0};
    glm::dvec3 look{0.0};
    double width = 0;      // of the picture at `look`; orthographic
    double fov = 0;        // degrees; 0: orthographic
    glm::dmat3 turn{1.0};  // columns: where the axes go
    bool general = false;  // no ray is in the plane between halves, thirds or fifths by design
};

/// Along an axis, along faces and along edges of halved squares and cubes, with rays in the planes
/// between their cells; from somewhere; in perspective, from a place in such planes; turned, so
/// that no number is round.
[[nodiscard]] std::vector<KnownView> known_views();

/// The scene's text: `render` are directives of its render block.
[[nodiscard]] std::string text_of(const KnownSurface& surface, const KnownView& view, int side,
                                  const std::string& render);

/// How a picture differs from what is known. Rays that pass an edge within `margin` of a pixel do
/// not count.
struct SurfaceVerdict {
    long rays = 0;        // that come to the surface, not at its edge
    long lost = 0;        // of these, those that see nothing or something behind it
    long beside = 0;      // hits farther from the surface than a cell may reach
    double farthest = 0;  // from the surface, in cells
    long flat = 0;        // of the rays, those with no edge nearby, of a face or of the whole
    long turned = 0;      // ... whose normal is `most_degrees` or more off
    double worst_degrees = 0;
    double mean_degrees = 0;
    long thin = 0;  // ... that are not opaque
    double least_alpha = 1;
    std::string report;  // the first few pixels that are wrong
};
[[nodiscard]] SurfaceVerdict judge(const KnownSurface& surface, const KnownView& view,
                                   const host::CompiledScene& scene, const host::Frame& frame,
                                   double most_degrees = 180);

}  // namespace pxm::test
