// How far a picture is from its reference.
#pragma once

#include <vector>

#include "host/render/render.hpp"

namespace pxm::host {

struct Deviation {
    double wrong_hits = 0;    // share of pixels: one hits, the other does not
    double wrong_share = 0;   // ... or both hit, more than a pixel apart
    double mean_depth = 0;    // pixels, over those that both hit
    double worst_depth = 0;   // pixels
    double rmse = 0;          // of colour, over red, green, blue
    double color_99 = 0;      // 99th percentile of a pixel's largest difference of colour
    double perceived = 0;     // share of pixels that a person tells apart: CIE delta E above 2.3
    std::vector<char> wrong;  // per pixel: counted in wrong_share
};

/// `scale`: the reference's world is so many times larger. The frames are of one size.
[[nodiscard]] Deviation deviation_of(const RenderResult& picture, const RenderResult& reference,
                                     double scale = 1);

}  // namespace pxm::host
