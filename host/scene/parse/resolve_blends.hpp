// `blend: A -> B, share` looks its maps up when the whole text is read, as all names are.
#pragma once

#include "host/scene/diagnostics.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {

/// Puts the matrix that it stands for in the place of every BlendCommand. Reports maps that are not
/// there, those that are blends of themselves, and those that cannot be blended
/// (host/math/blend.hpp).
void resolve_blends(Scene& scene, Diagnostics& diagnostics);

}  // namespace pxm::host
