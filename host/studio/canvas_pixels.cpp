#include "host/studio/canvas_pixels.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>

#include "host/output/pixel_values.hpp"

namespace pxm::host {

namespace {

bool same_color(const PixelRecord& a, const PixelRecord& b) {
    return std::ranges::equal(a.color, b.color);
}

std::uint32_t as_number(const unsigned char* rgb) {
    return 0xFF00'0000U | static_cast<std::uint32_t>(rgb[2]) << 16U |
           static_cast<std::uint32_t>(rgb[1]) << 8U | rgb[0];
}

}  // namespace

/// Most rows of most pictures are of one colour, the background.
CanvasPixels canvas_pixels(const Frame& frame) {
    CanvasPixels pixels{frame.columns(), frame.rows(), {}};
    const auto columns = static_cast<std::size_t>(frame.columns());
    std::vector<unsigned char> rgb(3 * columns);
    pixels.rgba.reserve(frame.pixels.size());
    for (std::size_t at = 0; at < frame.pixels.size(); at += columns) {
        const std::span row(frame.pixels.data() + at, columns);
        const bool even = std::ranges::all_of(
            row, [&](const PixelRecord& pixel) { return same_color(pixel, row.front()); });
        put_srgb_bytes(row.first(even ? 1 : columns), rgb.data());
        for (std::size_t i = 0; i < columns; ++i)
            pixels.rgba.push_back(as_number(rgb.data() + (even ? 0 : 3 * i)));
    }
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
