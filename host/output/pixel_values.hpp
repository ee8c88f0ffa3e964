// What files hold of a pixel: three bytes of sRGB, or floats of the channels that were asked for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "host/engine/aov.hpp"
#include "host/engine/frame.hpp"

namespace pxm::host {

/// The sRGB curve of a linear value, 0..1.
[[nodiscard]] float srgb_from_linear(float linear);

/// The byte of a linear value: 255 times its sRGB, rounded. What is not a number is 0.
[[nodiscard]] unsigned char srgb_byte(float linear);

/// Writes three bytes a pixel.
void put_srgb_bytes(std::span<const PixelRecord> pixels, unsigned char* to);

/// Writes four bytes a pixel, of which the last is 255, as one number: red is its lowest byte.
void put_srgb_words(std::span<const PixelRecord> pixels, std::uint32_t* to);

/// The channels of a file: red, green, blue, in an opaque file A, which is 1 as the colour has the
/// background in it, and those of `aovs`.
struct FloatChannels {
    bool opaque = false;
    std::vector<Aov> aovs;

    [[nodiscard]] std::vector<std::string> names() const;
};

/// Writes the channels' values of each pixel.
void put_floats(std::span<const PixelRecord> pixels, const FloatChannels& channels, float* to);

}  // namespace pxm::host
