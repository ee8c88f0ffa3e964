#include "tests/support/compile_text.hpp"

#include <stdexcept>

#include "host/scene/check/check.hpp"
#include "host/scene/parse/parser.hpp"

namespace pxm::test {

using namespace host;

CompiledScene compile_text(const std::string& text, double zoom, NearCells near_cells) {
    Diagnostics diagnostics;
    const auto stop_on_errors = [&](const Scene& scene) {
        if (diagnostics.has_errors()) throw std::runtime_error(diagnostics.text(scene.files));
    };
    const Scene scene = parse_text("test.pxm", text, diagnostics);
    stop_on_errors(scene);
    check_scene(scene, diagnostics);
    stop_on_errors(scene);
    CompiledScene compiled = compile(scene, zoom, diagnostics, near_cells);
    stop_on_errors(scene);
    return compiled;
}

EngineResult render_natively(const CompiledScene& scene, Numeric numeric, int threads) {
    return run_reference(scene, {nullptr, numeric, threads}, {});
}

EngineResult render_on(const std::string& model, const CompiledScene& scene, Numeric numeric,
                       int threads) {
    return run_on_machine(scene, {find_model(model), numeric, threads}, {});
}

}  // namespace pxm::test
