// Scenes for the oracle's campaign: random systems of 2 to 40 maps, with and without a graph, some
// squashed to 10^-4, mirrored, singular, or with a map that barely contracts (to 0.999), some on a
// grid where faces and cells coincide; seen from anywhere, magnified up to 10^12, with every kind
// of volume and every Lipschitz method. As data, so that what is found can be made smaller.
#pragma once

#include <cstdint>

#include "host/scene/scene.hpp"

namespace pxm::test {

[[nodiscard]] host::Scene random_system(std::uint64_t seed);

}  // namespace pxm::test
