// What the tracer is given and what it gives back: the features a scene needs, the constants of a
// frame, the result of a pixel. Node code: no allocation, no exceptions.
#pragma once

#include "dsp_kernels/plane.hpp"
#include "dsp_kernels/search_result.hpp"

namespace pxm::kernels {

/// What a scene needs of the tracer; what it does not is not compiled in.
struct Features {
    bool covers = false;   // local covers or translucent objects
    bool shadows = false;  // lights that cast shadows
    bool mirrors = false;  // surfaces that reflect
    bool area = false;     // local covers by area
};
inline constexpr Features plain_features{};                        // eye rays to solid objects
inline constexpr Features ray_features{false, true, true};         // with shadows and mirrors
inline constexpr Features all_features{true, true, true};          // and covers
inline constexpr Features area_features{false, true, true, true};  // and covers by area

/// What the tracer takes from the scene block, read once for all pixels.
template <class Real>
struct FrameConstants {
    Search<Real> search;    // of eye rays, without the ray
    ShadingMode shading;    // how normals are weighted
    Vec3<Real> background;  // linear colour where nothing is hit
    std::uint32_t planes;   // how many
    std::uint32_t bounces;  // most mirrors one after another
    std::uint32_t samples;  // eye rays of a pixel
    Real sample_share;      // 1 / samples
};

/// Which of a pixel's eye rays: the first one's cell stands for the pixel.
enum class Sample { first, other };

/// Rays of one pixel, beyond the eye's.
struct RayCounts {
    std::uint64_t light = 0;    // to lights
    std::uint64_t reflect = 0;  // from mirrors
};

/// What is known of a pixel once it is traced. Of several cells that show along its first ray,
/// `found` is the one that contributes most, unless the plane behind them, `floor`, does.
template <class Real>
struct PixelResult {
    Vec3<Real> color{};        // linear
    Real opacity{};            // 0: the background alone
    SearchResult<Real> found;  // of the first ray
    PlaneHit<Real> floor;      // behind it
    Vec3<Real> normal{};       // the total normal at `found`, or the normal of `floor`
    SearchCounts counts;       // of all its rays
    RayCounts rays;            // beyond the eye's
};

}  // namespace pxm::kernels
