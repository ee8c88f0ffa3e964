// From the text of a scene to a compiled scene, for tests that render.
#pragma once

#include <string>

#include "host/compile/compile.hpp"
#include "host/engine/engine.hpp"

namespace pxm::test {

/// Parses, checks and compiles. Throws std::runtime_error with the whole message text if the scene
/// has an error.
[[nodiscard]] host::CompiledScene compile_text(
    const std::string& text, double zoom = 1,
    host::NearCells near_cells = host::NearCells::replaced);

/// The scene on the cores at hand, or on the named model.
[[nodiscard]] host::EngineResult render_natively(const host::CompiledScene& scene,
                                                 host::Numeric numeric, int threads = 1);
[[nodiscard]] host::EngineResult render_on(const std::string& model,
                                           const host::CompiledScene& scene, host::Numeric numeric,
                                           int threads = 1);

}  // namespace pxm::test
