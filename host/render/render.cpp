// text -> parse -> scene -> check -> compile -> link -> load and broadcast -> every node: for each
// of my pixels ray, trace, store -> gather -> picture and statistics.
#include "host/render/render.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>

#include "host/engine/overflow.hpp"
#include "host/error.hpp"
#include "host/node_program/assembled_program.hpp"
#include "host/node_program/link.hpp"
#include "host/node_program/write_scene_block.hpp"
#include "host/output/spared_inputs.hpp"
#include "host/process/phase_clock.hpp"
#include "host/render/alarms.hpp"
#include "host/render/exposure.hpp"
#include "host/render/prepare.hpp"
#include "host/render/start.hpp"
#include "host/scene/words.hpp"
#include "host/wide/tile/wide_engine.hpp"

namespace pxm::host {

namespace {

/// What is known before the scene is loaded.
RenderResult begin_result(const RenderRequest& request, const Prepared& prepared,
                          const EngineChoice& choice, const NodeProgram& program) {
    RenderResult result;
    const CompiledScene& scene = prepared.compiled;
    result.warnings = prepared.warnings + crowd_text(scene, choice.numeric);
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

/// Rows of which all columns together are so many pixels: what is taken from an engine in blocks
/// and put together by rows.
long rows_at_once(const CropWindow& window) {
    constexpr long pixels = 8L << 20, least = 64;
    return std::max(least, pixels / (window.x1 - window.x0) / least * least);
}

/// Runs the engine and adds what it did. What its threads render is marked, counted and handed on
/// by them.
void run(StartedRender& started, const RunControl& control, PictureTaker* taker) {
    RenderResult& result = started.result;
    AlarmSums alarms;
    std::mutex mutex;
    const BlockTaker blocks{[&](Frame& block) {
                                const AlarmSums own = mark_alarms(started.alarms, block.pixels);
                                {
                                    const std::lock_guard lock(mutex);
                                    alarms.add(own);
                                }
                                taker->take(block);
                            },
                            rows_at_once(result.window)};
    if (taker) taker->begin(result);
    EngineResult run = started.loaded->run(result.window, control, taker ? &blocks : nullptr);
    result.stopped = run.stopped;
    result.frame = std::move(run.frame);
    if (!taker) {
        alarms = mark_alarms(started.alarms, result.frame.pixels);
        mark_misses(started.alarms, alarms, result.frame.pixels);
    }
    Statistics& statistics = result.statistics;
    statistics.alarms = alarms_of(started.alarms, alarms);
    statistics.rays = run.rays;
    statistics.machine = std::move(run.machine);
    statistics.seconds.render = run.render_seconds;
    statistics.seconds.encode = run.take_seconds;
}

}  // namespace

std::unique_ptr<LoadedScene> load(const CompiledScene& scene, const EngineChoice& choice) {
    if (choice.code == NodeCode::assembled) return load_assembled_machine(scene, choice);
    if (choice.machine) return load_machine(scene, choice);
    if (choice.intersect == IntersectMethod::wide) return wide::load_wide(scene, choice);
    return load_reference(scene, choice);
}

std::unique_ptr<StartedRender> start_render(const RenderRequest& request) {
    auto started = std::make_unique<StartedRender>();
    started->prepared = prepare(request);
    const Prepared& prepared = started->prepared;
    require_spared(request.outputs, inputs_of(prepared.scene));
    const NodeProgram program = request.code == NodeCode::assembled
                                    ? assembled_program(prepared.compiled).sizes()
                                    : link(prepared.compiled);
    if (request.machine) require_fit(program, std::string(request.machine->name));
    const IntersectChoice intersect = intersect_of(prepared, request);
    clear_overflow();  // of what the host computed
    const EngineChoice choice{request.machine,     numeric_of(prepared, request),
                              request.threads,     program.modules_bytes(),
                              program.stack_bytes, request.costs,
                              intersect.method,    request.code};
    // The wide engine places cells in double; in float is only what tells a tile's rays apart.
    const Numeric places =
        intersect.method == IntersectMethod::wide ? Numeric::double_ : choice.numeric;
    started->alarms = alarm_basis(prepared.compiled, places);
    started->result = begin_result(request, prepared, choice, program);
    Statistics& statistics = started->result.statistics;
    statistics.intersect_because = intersect.because;
    PhaseClock load_clock;
    started->loaded = prepared.walks.empty()
                          ? load(prepared.compiled, choice)
                          : load_reference_with(prepared.compiled, choice, prepared.walks);
    statistics.seconds.load = load_clock.lap();
    statistics.scene_block_words = started->loaded->block().size();
    statistics.scene_block_hash = block_hash(started->loaded->block());
    return started;
}

RenderResult render(const RenderRequest& request, const RunControl& control, PictureTaker* taker) {
    PhaseClock clock;
    const std::unique_ptr<StartedRender> started = start_render(request);
    if (has_exposure(request, started->prepared.scene))
        return render_exposure(request, started->prepared.scene, control, taker);
    RenderResult& result = started->result;
    run(*started, control, taker);
    result.warnings += cap_text(result.statistics.rays, started->prepared.compiled.cell_cap);
    result.warnings += alarm_text(result.statistics.alarms);
    result.statistics.seconds.total = clock.lap();
    return std::move(result);
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
