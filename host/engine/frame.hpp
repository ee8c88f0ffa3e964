// The gathered picture: per pixel the colour, what is known of how it came about, and where its
// numbers may not be enough (docs/alarms.md).
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "host/scene/scene.hpp"

namespace pxm::host {

/// Bits of PixelRecord::alarms.
enum PixelAlarm : std::uint8_t {
    alarm_precision = 1,   // the pixel is few units of the last place wide where it looks
    alarm_floored = 2,     // p would have to be finer than the numbers allow
    alarm_capped = 4,      // a ray of it was given up
    alarm_not_finite = 8,  // its depth, colour or normal is no number
    alarm_overflow = 16,   // a result on the way to it was beyond the numbers' range
};

struct Alarm {                // of pixels, or maps, that are doubtful
    std::string name;         // in --stats
    std::uint64_t count = 0;  // pixels, or maps
    std::string text;         // for the user
    bool of_pixels = true;    // not of maps
};

/// One pixel, one line of a cache. Colours are linear. On a miss: z infinite, object and level -1,
/// word 0, alpha 0.
struct alignas(64) PixelRecord {
    float color[3] = {0, 0, 0};                        // linear red, green and blue
    float alpha = 0;                                   // 0 on a miss, 1 behind what is opaque
    float z = std::numeric_limits<float>::infinity();  // distance along the ray, world units
    float normal[3] = {0, 0, 0};                       // the total normal
    std::int32_t object = -1;                          // its number in the scene
    std::int32_t level = -1;                           // how many maps deep the terminal cell is
    std::uint32_t word = 0;     // 24-bit hash of the terminal cell's word, never 0 on a hit
    std::uint32_t volumes = 0;  // volumes tested
    std::uint64_t cycles = 0;   // of 200 ns on the machine; natively what --aov neighbours asks for
    std::uint32_t heap = 0;     // most cells in the heap
    std::uint16_t node = 0;     // row * columns + column of the node that owns the pixel
    std::uint8_t alarms = 0;    // bits of PixelAlarm
};
static_assert(sizeof(PixelRecord) == 64);

/// Native renders go by squares of so many pixels a side: one pixel of each node of a 964.
inline constexpr int tile_side = 8;

/// The pixels of a crop window, row by row.
struct Frame {
    PixelSize size;                   // of the image
    CropWindow crop;                  // the window of it
    std::vector<PixelRecord> pixels;  // row by row
    Frame() = default;
    /// Pixels as on a miss.
    Frame(const PixelSize& image, const CropWindow& window)
        : size(image), crop(window), pixels(static_cast<std::size_t>(columns() * rows())) {}

    /// Becomes another window, with pixels as new, in the memory that there is.
    void renew(const PixelSize& image, const CropWindow& window) {
        size = image;
        crop = window;
        pixels.assign(static_cast<std::size_t>(columns() * rows()), PixelRecord{});
    }

    [[nodiscard]] long columns() const { return crop.x1 - crop.x0; }  // of the window
    [[nodiscard]] long rows() const { return crop.y1 - crop.y0; }     // of the window
    /// The pixel at image coordinates inside the crop window.
    [[nodiscard]] PixelRecord& at(long x, long y) {
        return pixels[static_cast<std::size_t>((y - crop.y0) * columns() + x - crop.x0)];
    }
    [[nodiscard]] const PixelRecord& at(long x, long y) const {
        return const_cast<Frame*>(this)->at(x, y);
    }  // the same
};

}  // namespace pxm::host
