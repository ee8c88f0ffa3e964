// A picture as a measure in the plane: an image's ink, or a list of points.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host/files/image_reader.hpp"
#include "host/import/moments/moments.hpp"

namespace pxm::host {

struct PlaneMeasure {
    std::vector<WeightedPoint> points;
    double finest = 0;  // distance between neighbours, 0 if it is not known
};

/// The image's ink: how far a pixel's grey (times its alpha) is from that of the border, at least a
/// quarter of the largest such difference. Pixels are points; the longer side of the image is 2,
/// its middle (0,0), y up. Throws Error(ErrorKind::scene) if the image is blank.
[[nodiscard]] PlaneMeasure picture_of(const LoadedImage& image);

/// Points from text: two numbers a line, or three, the third a weight; `#` and `;` start a comment.
/// Throws Error(ErrorKind::scene) at the place of a mistake.
[[nodiscard]] PlaneMeasure read_points(const std::string& name, const std::string& text);

}  // namespace pxm::host
