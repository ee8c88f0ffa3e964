// A frame of an animation whose shutter is open for a while: things that move leave a trace.
#pragma once

#include "host/render/render.hpp"

namespace pxm::host {

/// Whether the request is of such a frame: the scene has a shutter and several samples a pixel.
[[nodiscard]] bool has_exposure(const RenderRequest& request, const Scene& scene);

/// Renders each sample of all pixels at a moment of its own, evenly over the share of the frame's
/// time in which the shutter is open, and adds them up in that order. Colours and alpha are means;
/// depths, normals and cells are those of the first moment; counts are sums, and a pixel has an
/// alarm if it has it at any moment. Keeps one frame of 64 bytes a pixel. Throws as render().
[[nodiscard]] RenderResult render_exposure(const RenderRequest& request, const Scene& scene,
                                           const RunControl& control, PictureTaker* taker);

}  // namespace pxm::host
