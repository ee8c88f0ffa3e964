// The diameter of an attractor: the largest distance of two of its points, between what two points
// that are known have and what no two can have. Pairs of cells are divided, the most promising
// first.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <vector>

#include "host/fractal/bounds/bounds.hpp"
#include "host/fractal/system/rifs.hpp"

namespace pxm::host {

struct Diameter {                         // what is known of it
    double value = 0;                     // of the two points
    double upper = 0;                     // no two points are further apart
    double lower = 0;                     // some two are, whatever rounding did to the two named
    std::array<glm::dvec3, 2> between{};  // the two points
};

/// Of what may stand at the start. `bounds` as from bound(), `inner` points of each E_s.
[[nodiscard]] Diameter diameter(const Rifs& rifs, const std::vector<Bounds>& bounds,
                                const std::vector<std::vector<glm::dvec3>>& inner);

}  // namespace pxm::host
