// Which bounding volume each follow set of an object gets: declared or computed, and of which kind.
#pragma once

#include <vector>

#include "host/compiled/compiled_scene.hpp"
#include "host/fractal/bounds/bounds.hpp"
#include "host/fractal/system/rifs.hpp"
#include "host/scene/diagnostics.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {

/// One volume per follow set, in the coordinates of the ifs block. A declared volume stands for all
/// sets if it contains the attractor and rays do not meet thousands of cells; if not, a computed
/// one does and a warning says why, and by how much it fell short. Where only what may stand inside
/// some maps sticks out of it, computed ones are used there. `kind` other than automatic overrides
/// what is declared.
[[nodiscard]] std::vector<CompiledVolume> choose_volumes(const ObjectBlock& object, VolumeKind kind,
                                                         const Rifs& rifs,
                                                         const std::vector<Bounds>& bounds,
                                                         Diagnostics& diagnostics);

/// The volume of an object without an ifs, exactly as declared. Precondition: neither auto nor
/// hull.
[[nodiscard]] CompiledVolume primitive_volume(const DeclaredVolume& declared);

}  // namespace pxm::host
