// text -> parse -> scene -> check -> compile -> link -> load and broadcast -> every node: for each
// of my pixels ray, trace, store -> gather -> picture and statistics.
#include "host/render/render.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

#include "host/error.hpp"
#include "host/render/compile.hpp"
#include "host/render/link.hpp"
#include "host/render/overflow.hpp"
#include "host/scene/check.hpp"
#include "host/scene/parser.hpp"
#include "host/scene/words.hpp"
#include "host/wide/wide_scene.hpp"

namespace pxm::host {

namespace {

/// Seconds since the last call, for one phase after the other.
class PhaseClock {
  public:
    double lap() {
        const auto now = std::chrono::steady_clock::now();
        const double seconds = std::chrono::duration<double>(now - last_).count();
        last_ = now;
        return seconds;
    }

  private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

struct IntersectChoice {
    IntersectMethod method = IntersectMethod::heap;
    std::string because;
};

/// What `auto` stands for: the wide engine wherever it applies.
IntersectChoice choose_intersect(IntersectMethod asked, const std::string& why_not_wide) {
    if (asked == IntersectMethod::heap || asked == IntersectMethod::fast) {
        return {asked, "it was asked for"};
    }
    if (!why_not_wide.empty()) return {IntersectMethod::heap, why_not_wide};
    return {IntersectMethod::wide, asked == IntersectMethod::wide
                                       ? "it was asked for"
                                       : "a native render in float whose objects it can do"};
}

/// A scene that was parsed, checked and compiled without an error.
struct Prepared {
    Scene scene;
    CompiledScene compiled;
    std::string warnings;
    double parse_seconds = 0;
    double compile_seconds = 0;
};

Prepared prepare(const RenderRequest& request) {
    PhaseClock clock;
    Prepared prepared;
    Diagnostics diagnostics;
    prepared.scene = parse_scene(request.scene_path, diagnostics);
    if (!diagnostics.has_errors()) {
        apply(request.overrides, prepared.scene);
        check_scene(prepared.scene, diagnostics);
    }
    prepared.parse_seconds = clock.lap();
    if (!diagnostics.has_errors()) {
        prepared.compiled = compile(prepared.scene, request.overrides.zoom, diagnostics);
    }
    if (request.cell_cap) prepared.compiled.cell_cap = *request.cell_cap;
    diagnostics.throw_if_errors(prepared.scene.files);
    prepared.warnings = diagnostics.warnings_text(prepared.scene.files);
    if (!prepared.warnings.empty()) prepared.warnings += '\n';
    prepared.compile_seconds = clock.lap();
    return prepared;
}

/// The machine's own numbers on the machine, float on the cores at hand, unless the scene says.
Numeric numeric_of(const Prepared& prepared, const RenderRequest& request) {
    const RenderBlock render = prepared.scene.render.value_or(RenderBlock{});
    return render.numeric.value_or(request.machine ? Numeric::dsp32 : Numeric::single);
}

/// How the first cells are found. To insist on the wide engine where it does not apply is an error
/// of whoever insists.
IntersectChoice intersect_of(const Prepared& prepared, const RenderRequest& request) {
    const RenderBlock render = prepared.scene.render.value_or(RenderBlock{});
    const IntersectMethod asked = render.intersect.value_or(IntersectMethod::automatic);
    const std::string why_not =
        request.machine ? "the machine's nodes have no wide registers"
                        : wide::why_not_wide(prepared.compiled, numeric_of(prepared, request));
    if (asked != IntersectMethod::wide || why_not.empty()) return choose_intersect(asked, why_not);
    if (request.overrides.intersect) {
        throw Error(ExitCode::command_line, "--intersect wide: " + why_not);
    }
    Diagnostics diagnostics;
    diagnostics.error(render.intersect_position, "render: 'intersect: wide': " + why_not);
    diagnostics.throw_if_errors(prepared.scene.files);
    return {};
}

const char* name_of(Numeric numeric) {
    switch (numeric) {
        case Numeric::dsp32:
            return "dsp32";
        case Numeric::single:
            return "float";
        case Numeric::twice:
            return "double";
    }
    return "";
}

}  // namespace

RenderResult render(const RenderRequest& request, const RunControl& control) {
    PhaseClock clock;
    const Prepared prepared = prepare(request);
    const NodeProgram program = link(prepared.compiled);
    if (request.machine) require_fit(program, std::string(request.machine->name));
    const IntersectChoice intersect = intersect_of(prepared, request);
    clear_overflow();  // of what the host computed
    const EngineChoice choice{request.machine,     numeric_of(prepared, request),
                              request.threads,     program.modules_bytes(),
                              program.stack_bytes, request.costs,
                              intersect.method};
    EngineResult run = request.machine ? run_on_machine(prepared.compiled, choice, control)
                                       : run_natively(prepared.compiled, choice, control);

    RenderResult result;
    result.warnings = prepared.warnings;
    if (run.rays.capped_rays > 0) {
        result.warnings += fmt::format(
            "warning: {} of {} rays were given up after {} cells; their pixels show the nearest "
            "cell "
            "known by then\n",
            run.rays.capped_rays, run.rays.eye_rays + run.rays.light_rays + run.rays.reflect_rays,
            prepared.compiled.cell_cap);
    }
    result.stopped = run.stopped;
    const double coarser = std::sqrt(static_cast<double>(prepared.compiled.samples.size()));
    result.pixel_at_eye = prepared.compiled.camera.pixel_at_eye * prepared.compiled.unit * coarser;
    result.pixel_growth = prepared.compiled.camera.pixel_growth * coarser;
    result.frame = std::move(run.frame);
    // The wide engine places cells in double; in float is only what tells a tile's rays apart.
    const Numeric places =
        intersect.method == IntersectMethod::wide ? Numeric::twice : choice.numeric;
    result.statistics.alarms = raise_alarms(prepared.compiled, places, result.frame);
    result.warnings += alarm_text(result.statistics.alarms);
    Statistics& statistics = result.statistics;
    statistics.scene = request.scene_path;
    statistics.engine = request.machine ? "machine" : "native";
    statistics.model = request.machine ? std::string(request.machine->name) : "";
    statistics.numeric = name_of(choice.numeric);
    statistics.size = prepared.compiled.size;
    statistics.threads = request.threads;
    statistics.intersect = word_of(intersect_words, intersect.method);
    statistics.intersect_because = intersect.because;
    statistics.rays = run.rays;
    statistics.scene_block_words = run.scene_block_words;
    statistics.scene_block_hash = run.scene_block_hash;
    statistics.program = program;
    statistics.machine = std::move(run.machine);
    statistics.seconds = {prepared.parse_seconds,
                          prepared.compile_seconds,
                          run.load_seconds,
                          run.render_seconds,
                          0,
                          clock.lap()};
    return result;
}

CompiledScene compiled_scene_of(const RenderRequest& request) { return prepare(request).compiled; }

std::string explain_pixel(const RenderRequest& request, long x, long y) {
    const Prepared prepared = prepare(request);
    const PixelSize& size = prepared.compiled.size;
    if (x < 0 || y < 0 || x >= size.columns || y >= size.rows) {
        throw Error(ExitCode::command_line, fmt::format("--pixel {},{} is outside the {}x{} image",
                                                        x, y, size.columns, size.rows));
    }
    return prepared.warnings +
           describe_pixel(prepared.compiled, numeric_of(prepared, request), x, y);
}

}  // namespace pxm::host
