// A solid cube seen face on: a square whose share of every pixel is known by area.
#pragma once

#include <string>

#include "host/engine/frame.hpp"

namespace pxm::test {

inline constexpr long square_side = 48;  // of the picture, in pixels

/// An ifs block whose attractor is the cube [-1,1]^3.
[[nodiscard]] std::string cube_text();

/// The cube as a square of half the picture's width, turned by so many degrees; without a render
/// block.
[[nodiscard]] std::string square_text(double degrees);

/// The share of pixel (x, y) that the square covers, on a grid of 32 x 32 points.
[[nodiscard]] double area_of_square(double degrees, long x, long y);

/// Opacity minus area, over the pixels of the square's edge.
struct AreaError {
    double mean = 0;
    double rms = 0;
    long pixels = 0;
    long not_solid = 0;  // pixels inside that are not opaque
};
[[nodiscard]] AreaError area_error(const host::Frame& frame, double degrees);

}  // namespace pxm::test
