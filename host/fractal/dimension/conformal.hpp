// Maps that are all similitudes in some other coordinates: some ellipsoid becomes a smaller copy of
// itself under each of them, up to turns within it.
#pragma once

#include <optional>
#include <vector>

#include "host/fractal/system/rifs.hpp"

namespace pxm::host {

struct ConformalRatios {
    std::vector<double> log_ratio;  // per map
    double error = 0;               // of the ratios, relative
};

/// Nothing unless one ellipsoid serves all maps. `n`: maps have entries in the first n axes only.
[[nodiscard]] std::optional<ConformalRatios> conformal_ratios(const Rifs& rifs, int n);

}  // namespace pxm::host
