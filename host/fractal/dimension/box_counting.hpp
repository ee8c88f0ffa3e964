// The box-counting dimension (Def. 5.5), measured: the boxes of a grid that hold points of the
// attractor are counted at many scales, and a line is fitted to log count against log resolution
// (Sec. 5.3.1). A million boxes a side are too many to look at; they are counted by places, which
// Zoom looks at closer and closer.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/fractal/bounds/bounds.hpp"
#include "host/fractal/system/rifs.hpp"

namespace pxm::host {

struct BoxScale {      // boxes of one size
    double side = 0;   // of a box
    double boxes = 0;  // that hold a point, about
};

struct BoxCounting {                  // what was measured
    std::optional<double> dimension;  // nothing if there is no range of scales that tells it
    double error = 0;                 // of 20 systems, 19 are within it
    std::vector<BoxScale> scales;     // coarse to fine; the coarsest third is not used
    long points = 0;                  // places looked at
    std::string method;               // what was done, or what kept from measuring
};

/// Of what may stand at the start. The same system gives the same result, by any number of threads.
/// `bounds` as from bound().
[[nodiscard]] BoxCounting count_boxes(const Rifs& rifs, const std::vector<Bounds>& bounds,
                                      int threads = 1);

}  // namespace pxm::host
