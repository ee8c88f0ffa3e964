// The box-counting dimension (Def. 5.5), measured: points of the attractor are sorted into grids of
// several resolutions, and a line is fitted to log count against log resolution (Sec. 5.3.1).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/fractal/bounds.hpp"
#include "host/fractal/rifs.hpp"

namespace pxm::host {

struct BoxScale {
    double side = 0;  // of a box
    long boxes = 0;   // that hold a point
};

struct BoxCounting {
    std::optional<double> dimension;  // nothing if too few scales could be counted
    double error = 0;                 // standard error of the fitted slope
    std::vector<BoxScale> scales;     // coarse to fine: those of the fit
    long points = 0;
    std::string method;  // where the points come from, or which limit kept from measuring
};

/// Of what may stand at the start. The same system gives the same result. `bounds` as from bound().
[[nodiscard]] BoxCounting count_boxes(const Rifs& rifs, const std::vector<Bounds>& bounds);

}  // namespace pxm::host
