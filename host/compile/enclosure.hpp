// Cells around the eye's surroundings that became too large for the nodes' numbers: what is left of
// them is the normal that they give to rays that enter them (Ch. 17). Their volumes are moved to
// the eye, so that a face close by is a small number.
#pragma once

#include <optional>

#include "host/compiled/compiled_scene.hpp"
#include "host/math/precise.hpp"

namespace pxm::host {

/// Which rays there are: from the eye alone, or from places it sees as well.
enum class Rays { from_the_eye, from_everywhere };

/// The cell that `place` takes from its shape's coordinates to the world about the eye, and its
/// diameter in world units. Nothing if no ray enters it. Cones and cylinders give no normal.
[[nodiscard]] std::optional<CompiledEnclosure> enclosure(const PreciseAffine& place,
                                                         const CompiledVolume& volume,
                                                         double diameter, double unit, Rays rays);

/// One that no ray enters, of that diameter.
[[nodiscard]] CompiledEnclosure silent_enclosure(double diameter, double unit);

}  // namespace pxm::host
