#include "host/studio/canvas_pixels.hpp"

#include <algorithm>
#include <limits>

#include "host/output/pixel_values.hpp"

namespace pxm::host {

CanvasPixels canvas_pixels(const Frame& frame) {
    CanvasPixels pixels{frame.columns(), frame.rows(),
                        std::vector<std::uint32_t>(frame.pixels.size())};
    put_srgb_words(frame.pixels, pixels.rgba.data());
    return pixels;
}

std::vector<std::uint32_t> canvas_cycles(const Frame& frame) {
    std::vector<std::uint32_t> cycles;
    cycles.reserve(frame.pixels.size());
    for (const PixelRecord& pixel : frame.pixels)
        cycles.push_back(static_cast<std::uint32_t>(
            std::min<std::uint64_t>(pixel.cycles, std::numeric_limits<std::uint32_t>::max())));
    return cycles;
}

}  // namespace pxm::host
