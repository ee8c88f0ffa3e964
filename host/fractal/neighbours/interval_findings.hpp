// What follows for a system whose numbers are in no number field of moderate size, from balls of
// certified radius that they lie in: that images are apart, and that sums are less or more than 1.
// Neither that two words are the same map nor that two images have a common point is decided so.
#pragma once

#include <string>
#include <vector>

#include "host/fractal/bounds/bounds.hpp"
#include "host/fractal/exact/ball_system.hpp"
#include "host/fractal/neighbours/exact_findings.hpp"
#include "host/fractal/system/rifs.hpp"

namespace pxm::host {

/// `bounds` as from bound(); `numbers` says what the balls are. Precondition: the system contracts,
/// and every follow set is reached from the start.
[[nodiscard]] ExactFindings find_by_intervals(const exact::BallMaps& balls, const Rifs& rifs,
                                              const std::vector<Bounds>& bounds,
                                              const std::string& numbers);

}  // namespace pxm::host
