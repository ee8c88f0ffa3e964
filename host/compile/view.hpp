// Where the eye is and what a pixel spans: the camera block with its defaults.
#pragma once

#include <glm/vec3.hpp>

#include "host/compiled/compiled_scene.hpp"
#include "host/fractal/bounds/bounds.hpp"
#include "host/math/precise.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {

/// A camera in world units.
struct View {
    glm::dvec3 eye{0.0};
    PreciseVec3 exact_eye;
    double look_distance = 0;           // from the eye to the look point
    glm::dvec3 forward{0.0, 0.0, 1.0};  // unit vectors of a left-handed frame
    glm::dvec3 right{1.0, 0.0, 0.0};
    glm::dvec3 up{0.0, 1.0, 0.0};
    double half_width = 1;  // tan(fov / 2), or half the orthographic width
    bool orthographic = false;
};

/// The view of a scene whose objects lie in `ball`. What the camera block leaves out: 40 degrees,
/// looking at the ball's centre from the direction (0.4, 0.5, -1) at the distance where it just
/// fits with a tenth of margin, up (0,1,0).
[[nodiscard]] View make_view(const CameraBlock& camera, const PixelSize& size, const Ball& ball,
                             double outer_zoom);

/// The camera with what make_view() takes for its eye and look point, before any zoom.
[[nodiscard]] CameraBlock with_places(CameraBlock camera, const PixelSize& size, const Ball& ball);

/// p at a distance from the eye, world units (Eq. 15.2).
[[nodiscard]] double pixel_size(const View& view, const PixelSize& size, double distance);

/// The view with the eye at the origin and lengths divided by `unit`.
[[nodiscard]] CompiledCamera compile_view(const View& view, const PixelSize& size, double unit);

}  // namespace pxm::host
