// Systems whose box-counting dimension the literature knows: [Mandelbrot82], [Falconer90], [BM84],
// and what follows from Moran's equation for similitudes with the open-set condition.
#pragma once

#include <string>
#include <vector>

#include "host/fractal/system/rifs.hpp"

namespace pxm::host::systems {

struct KnownSystem {
    std::string name;
    Rifs rifs;
    double dimension = 0;
};

/// More than fifty, in the line, the plane and space; curves, dusts, tiles, carpets and graphs.
[[nodiscard]] std::vector<KnownSystem> known_systems();

}  // namespace pxm::host::systems
