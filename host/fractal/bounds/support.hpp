// The support function of the attractor, h_s(u) = max of u . x over E_s: how far it reaches in a
// direction. With x' = x T + a it obeys h_s(u) = max over m in s of h_t(u T_m^T) + u . a_m, t what
// may stand inside m. Best-first descent; of all cells with one follow set and one direction up to
// scale only the largest offset is kept, or a face perpendicular to u would cost 20^k cells on
// Menger.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "host/fractal/bounds/approximation.hpp"

namespace pxm::host {

struct Reach {
    double upper = 0;     // h is not larger, up to ...
    double rounding = 0;  // ... what may be missing for rounding
    double lower = 0;     // the reach of `point`, as computed
    glm::dvec3 point{0.0};
    long cells = 0;  // looked at

    /// h is not larger, rounding or not.
    [[nodiscard]] double at_most() const { return Rounded{upper, rounding}.at_most(); }
};

/// h_set(u), to `tolerance` unless more than `budget` cells would have to be looked at.
[[nodiscard]] Reach reach(const Rifs& rifs, const Approximation& known, int set,
                          const glm::dvec3& u, double tolerance, long budget);

/// h_set(u) from above, rounding or not, to `tolerance` unless that takes too long. `bounds` as
/// from bound().
[[nodiscard]] double support(const Rifs& rifs, const std::vector<Bounds>& bounds, int set,
                             const glm::dvec3& u, double tolerance);

}  // namespace pxm::host
