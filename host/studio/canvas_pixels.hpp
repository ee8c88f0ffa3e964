// Pixels as a canvas has them: red, green, blue and 255 in four bytes, which are one number here.
#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "host/engine/frame.hpp"

namespace pxm::host {

static_assert(std::endian::native == std::endian::little, "red is the lowest byte of the number");

struct CanvasPixels {
    long columns = 0;
    long rows = 0;
    std::vector<std::uint32_t> rgba;  // row by row

    [[nodiscard]] std::span<const std::uint32_t> row(long y) const {
        return std::span(rgba).subspan(static_cast<std::size_t>(y * columns),
                                       static_cast<std::size_t>(columns));
    }
};

[[nodiscard]] CanvasPixels canvas_pixels(const Frame& frame);

/// What each pixel cost, as far as four bytes hold it.
[[nodiscard]] std::vector<std::uint32_t> canvas_cycles(const Frame& frame);

}  // namespace pxm::host
