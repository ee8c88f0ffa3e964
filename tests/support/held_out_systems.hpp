// Systems of known box-counting dimension that the measurement was not made with: drawn at random
// where a theorem tells the dimension, and figures of the literature beside those of
// known_systems.hpp. Whoever changes box counting looks at the others.
#pragma once

#include <vector>

#include "tests/support/known_systems.hpp"

namespace pxm::host::systems {

/// About a hundred, the same each time.
[[nodiscard]] std::vector<KnownSystem> held_out_systems();

}  // namespace pxm::host::systems
