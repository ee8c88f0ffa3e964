// What a native render of a scene will take of this computer: `pxm inspect --needs`. It is
// measured, by rendering some of the pixels.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>

#include "host/render/render.hpp"

namespace pxm::host {

struct RenderNeeds {
    std::string scene;
    PixelSize size;
    double cpu_seconds = 0;  // of all threads
    double seconds = 0;      // of the clock, if nothing else runs
    int threads = 1;
    std::uint64_t bytes = 0;  // of memory, at most at a time
    long trial_pixels = 0;
};

/// Renders squares that are spread over the picture, until enough is known. Nothing if it was
/// stopped. Throws Error as render() does.
[[nodiscard]] std::optional<RenderNeeds> render_needs(const RenderRequest& request,
                                                      const std::atomic<bool>& stop);

[[nodiscard]] std::string render_needs_text(const RenderNeeds& needs);
/// One object: `scene`, `size`, `cpu_seconds`, `seconds`, `threads`, `bytes`, `trial_pixels`.
[[nodiscard]] std::string render_needs_json(const RenderNeeds& needs);

}  // namespace pxm::host
