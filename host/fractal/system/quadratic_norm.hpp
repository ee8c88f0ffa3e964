// Ellipsoids that the maps of a system contract, though balls they may not: the proof that the
// spectral radius of sum T_i (x) T_i is below 1 (thesis-notes, (b); a block for each follow set).
#pragma once

#include <glm/mat3x3.hpp>
#include <optional>
#include <vector>

#include "host/fractal/system/rifs.hpp"

namespace pxm::host {

/// An ellipsoid for each follow set, frame * unit ball, such that for every set s and map m of s
/// with follow set t: map m takes the ellipsoid of t into `rate` times the ellipsoid of s, up to
/// where. Frames are lower triangular; the rate was checked in brackets.
struct QuadraticNorm {
    std::vector<glm::dmat3> frame;
    double rate = 0;
};

/// Nothing if no rate below 1 was found and proven. Precondition: every map is finite.
[[nodiscard]] std::optional<QuadraticNorm> contracting_norm(const Rifs& rifs);

}  // namespace pxm::host
