// Systems of known box-counting dimension that the measurement was not made with: drawn at random
// where a theorem tells the dimension, and figures of the literature beside those of
// known_systems.hpp. Whoever changes box counting looks at the others.
#pragma once

#include <cstdint>
#include <vector>

#include "tests/support/known_systems.hpp"

namespace pxm::host::systems {

/// So many of each of thirteen kinds, of which two have copies that overlap and three are affine,
/// and eighteen others. The same each time.
[[nodiscard]] std::vector<KnownSystem> held_out_systems(std::uint64_t of_a_kind);

}  // namespace pxm::host::systems
