// The mattes of a picture: which objects, and which of their maps, its samples show. The rays are
// followed again for it, sample by sample, as a frame knows of a pixel one cell alone.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "host/output/cryptomatte.hpp"
#include "host/render/render.hpp"

namespace pxm::host {

enum class MatteKind { object, map };

inline constexpr long matte_pixels = 4096L * 4096;  // 48 bytes each, and for each kind
inline constexpr std::size_t matte_maps = 1024;     // of all objects

/// The mattes of the request's picture, in the order of `kinds`; none if it was stopped. Objects go
/// by their names; `map` is the outermost map of what is seen, which says what part of the object
/// it is: `elm/branch`. Throws as render(), and Error(ErrorKind::setting) for a window of more than
/// matte_pixels, objects of more than matte_maps, and an open shutter.
[[nodiscard]] std::vector<MatteLayer> render_mattes(const RenderRequest& request,
                                                    const std::vector<MatteKind>& kinds,
                                                    const RunControl& control);

}  // namespace pxm::host
