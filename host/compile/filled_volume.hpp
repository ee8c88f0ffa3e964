// Volumes of attractors that fill what bounds them (host/fractal/bounds/filled): a ray enters them
// where it comes to the attractor, and their faces are turned as it is.
#pragma once

#include <optional>
#include <vector>

#include "host/compile/computed_volume.hpp"

namespace pxm::host {

/// One volume for each set: boxes where those are exact, else hulls; polygons get thin ones.
/// Nothing if the system fills nothing. `bounds` as from bound(), as those of `computer`.
[[nodiscard]] std::optional<std::vector<CompiledVolume>> filled_volumes(
    const Rifs& rifs, const std::vector<Bounds>& bounds, VolumeComputer& computer);

}  // namespace pxm::host
