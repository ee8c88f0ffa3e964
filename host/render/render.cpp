// text -> parse -> scene -> check -> compile -> link -> load and broadcast -> every node: for each
// of my pixels ray, trace, store -> gather -> picture and statistics.
#include "host/render/render.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/engine/overflow.hpp"
#include "host/error.hpp"
#include "host/node_program/link.hpp"
#include "host/node_program/write_scene_block.hpp"
#include "host/output/spared_inputs.hpp"
#include "host/process/phase_clock.hpp"
#include "host/render/alarms.hpp"
#include "host/render/prepare.hpp"
#include "host/scene/words.hpp"
#include "host/wide/tile/wide_engine.hpp"

namespace pxm::host {

namespace {

/// What is known before the first ray.
RenderResult begin_result(const RenderRequest& request, const Prepared& prepared,
                          const EngineChoice& choice, const NodeProgram& program) {
    RenderResult result;
    const CompiledScene& scene = prepared.compiled;
    result.warnings = prepared.warnings;
    const double coarser = std::sqrt(static_cast<double>(scene.samples.size()));
    result.pixel_at_eye = scene.camera.pixel_at_eye * scene.unit * coarser;
    result.pixel_growth = scene.camera.pixel_growth * coarser;
    result.window = scene.crop;
    Statistics& statistics = result.statistics;
    statistics.scene = request.scene_path;
    statistics.engine = request.machine ? "machine" : "native";
    statistics.model = request.machine ? std::string(request.machine->name) : "";
    statistics.numeric = word_of(numeric_words, choice.numeric);
    statistics.size = scene.size;
    statistics.threads = request.threads;
    statistics.threads_because = request.threads_because;
    statistics.intersect = word_of(intersect_words, choice.intersect);
    statistics.rerooted = rerooted(scene);
    statistics.program = program;
    statistics.seconds.parse = prepared.parse_seconds;
    statistics.seconds.compile = prepared.compile_seconds;
    return result;
}

/// Adds what an engine did for the whole window, or for a band of it.
void add_run(RenderResult& result, const CompiledScene& scene, Numeric numeric, EngineResult run) {
    Statistics& statistics = result.statistics;
    result.stopped = run.stopped;
    result.frame = std::move(run.frame);
    add_pixels(statistics.alarms, raise_alarms(scene, numeric, result.frame));
    statistics.rays.add(run.rays);
    statistics.machine = std::move(run.machine);
    statistics.seconds.render += run.render_seconds;
}

std::string warnings_about(const RayStatistics& rays, std::uint32_t cell_cap) {
    if (rays.capped_rays == 0) return "";
    return fmt::format(
        "warning: {} of {} rays were given up after {} cells; their pixels show the nearest cell "
        "known by then\n",
        rays.capped_rays, rays.eye_rays + rays.light_rays + rays.reflect_rays, cell_cap);
}

/// The window in bands of whole rows of tiles, each at most so large as a frame in memory.
std::vector<CropWindow> bands_of(const CropWindow& window) {
    constexpr long most_bytes = 128L << 20;
    const long row_bytes = (window.x1 - window.x0) * static_cast<long>(sizeof(PixelRecord));
    const long rows = std::max<long>(tile_side, most_bytes / row_bytes / tile_side * tile_side);
    std::vector<CropWindow> bands;
    for (long top = window.y0; top < window.y1;) {
        const long bottom = std::min(window.y1, (top / tile_side) * tile_side + rows);
        bands.push_back({window.x0, top, window.x1, bottom});
        top = bottom;
    }
    return bands;
}

/// The same control, whose progress is that of one of several parts.
RunControl control_of_part(const RunControl& control, std::size_t part, std::size_t parts) {
    RunControl own = control;
    if (!control.progress) return own;
    own.progress = [&control, part, parts](double share) {
        control.progress((static_cast<double>(part) + share) / static_cast<double>(parts));
    };
    return own;
}

}  // namespace

std::unique_ptr<LoadedScene> load(const CompiledScene& scene, const EngineChoice& choice) {
    if (choice.machine) return load_machine(scene, choice);
    if (choice.intersect == IntersectMethod::wide) return wide::load_wide(scene, choice);
    return load_reference(scene, choice);
}

RenderResult render(const RenderRequest& request, const RunControl& control, const TakeBand& take) {
    PhaseClock clock;
    const Prepared prepared = prepare(request);
    require_spared(request.outputs, inputs_of(prepared.scene));
    const NodeProgram program = link(prepared.compiled);
    if (request.machine) require_fit(program, std::string(request.machine->name));
    const IntersectChoice intersect = intersect_of(prepared, request);
    clear_overflow();  // of what the host computed
    const EngineChoice choice{request.machine,     numeric_of(prepared, request),
                              request.threads,     program.modules_bytes(),
                              program.stack_bytes, request.costs,
                              intersect.method};
    // The wide engine places cells in double; in float is only what tells a tile's rays apart.
    const Numeric places =
        intersect.method == IntersectMethod::wide ? Numeric::double_ : choice.numeric;
    RenderResult result = begin_result(request, prepared, choice, program);
    result.statistics.intersect_because = intersect.because;
    PhaseClock load_clock;
    const std::unique_ptr<LoadedScene> loaded = load(prepared.compiled, choice);
    result.statistics.seconds.load = load_clock.lap();
    result.statistics.scene_block_words = loaded->block().size();
    result.statistics.scene_block_hash = block_hash(loaded->block());
    const std::vector<CropWindow> bands =
        take && !request.machine ? bands_of(result.window) : std::vector{result.window};
    for (std::size_t i = 0; i < bands.size() && !result.stopped; ++i) {
        add_run(result, prepared.compiled, places,
                loaded->run(bands[i], control_of_part(control, i, bands.size())));
        if (take && !result.stopped) take(result);
    }
    result.warnings += warnings_about(result.statistics.rays, prepared.compiled.cell_cap);
    result.warnings += alarm_text(result.statistics.alarms);
    result.statistics.seconds.total = clock.lap();
    return result;
}

CompiledScene compiled_scene_of(const RenderRequest& request) { return prepare(request).compiled; }

std::string explain_pixel(const RenderRequest& request, long x, long y) {
    const Prepared prepared = prepare(request);
    const PixelSize& size = prepared.compiled.size;
    if (x < 0 || y < 0 || x >= size.columns || y >= size.rows) {
        throw Error(ErrorKind::setting, fmt::format("--pixel {},{} is outside the {}x{} image", x,
                                                    y, size.columns, size.rows));
    }
    return prepared.warnings +
           describe_pixel(prepared.compiled, numeric_of(prepared, request), x, y);
}

}  // namespace pxm::host
