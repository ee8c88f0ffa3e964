// The numbers that native renders compute with unless the scene says.
#pragma once

#include "host/compiled/compiled_scene.hpp"

namespace pxm::host {

/// Float; double where the reference kernels have to do the scene and it has hulls: a ray in the
/// face between two of them meets both, and in float it is lost to neither only by luck.
[[nodiscard]] Numeric native_numeric(const CompiledScene& scene);

}  // namespace pxm::host
