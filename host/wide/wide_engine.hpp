// The wide engine: the native engine on wide registers. The same picture as the clear kernels give
// in double (docs/design.md, decision 4), found another way.
#pragma once

#include "host/render/engine.hpp"

namespace pxm::host::wide {

/// Renders 8x8 tiles with OpenMP. Precondition: why_not_wide(scene) is empty.
[[nodiscard]] EngineResult run_wide(const CompiledScene& scene, const EngineChoice& choice,
                                    const RunControl& control);

}  // namespace pxm::host::wide
