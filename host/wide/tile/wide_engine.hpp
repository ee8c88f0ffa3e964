// The wide engine: the native engine on wide registers. The same picture as the reference kernels
// give in double (docs/design.md, decision 4), found another way.
#pragma once

#include "host/engine/engine.hpp"

namespace pxm::host::wide {

/// Precondition: why_not_wide(scene) is empty. Keeps a reference to `scene`.
[[nodiscard]] std::unique_ptr<LoadedScene> load_wide(const CompiledScene& scene,
                                                     const EngineChoice& choice);

/// The whole crop window, loaded for this one run.
[[nodiscard]] EngineResult run_wide(const CompiledScene& scene, const EngineChoice& choice,
                                    const RunControl& control);

}  // namespace pxm::host::wide
