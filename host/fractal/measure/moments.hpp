// The mean and the spread of the measure that a random descent leaves on an attractor
// [Hutchinson81]: in a follow set, map m has probability weight_m over the sum of the set's
// weights. Both obey the measure's own equation, mu = sum of p_m mu(w_m^-1), so that no point is
// drawn.
#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "host/fractal/system/rifs.hpp"

namespace pxm::host {

struct Moments {                        // of the measure
    glm::dvec3 centroid{0.0};           // its mean
    glm::dmat3 covariance{0.0};         // about the mean
    std::array<glm::dvec3, 3> axes{};   // unit; the one of the largest variance first
    std::array<double, 3> variances{};  // along them
    /// No coordinate of the centroid is further off, for the maps as the doubles that they are;
    /// infinite where no bound is known.
    double centroid_error = 0;
    double variance_error = 0;  // the same of each variance
    /// Per axis: the sine of the angle that it is off by at most. 1: nothing is known of it, as
    /// where two variances are the same.
    std::array<double, 3> axis_errors{};
};

/// Of what may stand at the start. Nothing if the sums do not come to rest. Precondition: the
/// system contracts; every follow set has a map of positive weight.
[[nodiscard]] std::optional<Moments> moments(const Rifs& rifs, const std::vector<double>& weights);

}  // namespace pxm::host
