#include "host/wide/wide_engine.hpp"

#include <omp.h>

#include <chrono>
#include <exception>

#include "host/render/scene_block.hpp"
#include "host/wide/tile_tracer.hpp"

namespace pxm::host::wide {

namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

EngineResult run_wide(const CompiledScene& scene, const EngineChoice& choice,
                      const RunControl& control) {
    const auto start = std::chrono::steady_clock::now();
    EngineResult result;
    const std::vector<std::uint32_t> block = make_scene_block<double>(scene);
    const WideScene wide = make_wide_scene(scene);
    const ClearRest rest(scene, wide);
    result.frame = Frame(scene.size, scene.crop);
    result.scene_block_words = block.size();
    result.scene_block_hash = block_hash(block);
    result.load_seconds = seconds_since(start);

    const auto render_start = std::chrono::steady_clock::now();
    const long first_column = scene.crop.x0 / tile_side;
    const long first_row = scene.crop.y0 / tile_side;
    const long across = (scene.crop.x1 + tile_side - 1) / tile_side - first_column;
    const long tiles = across * ((scene.crop.y1 + tile_side - 1) / tile_side - first_row);
    std::atomic<long> done = 0;
    std::atomic<bool> stopped = false;
    std::exception_ptr failure;
#pragma omp parallel num_threads(choice.threads)
    {
        try {
            TileTracer tracer(scene, wide, rest, block, result.frame);
#pragma omp for schedule(dynamic, 4) nowait
            for (long tile = 0; tile < tiles; ++tile) {
                if (control.stop && *control.stop) stopped = true;
                if (stopped.load(std::memory_order_relaxed)) continue;
                tracer.render((first_column + tile % across) * tile_side,
                              (first_row + tile / across) * tile_side);
                const long finished = ++done;
                if (control.progress && omp_get_thread_num() == 0) {
                    control.progress(static_cast<double>(finished) / static_cast<double>(tiles));
                }
            }
#pragma omp critical(pxm_wide_sum)
            { result.rays.add(tracer.rays); }
        } catch (...) {
#pragma omp critical(pxm_wide_failure)
            failure = std::current_exception();
            stopped = true;
        }
    }
    if (failure) std::rethrow_exception(failure);
    result.stopped = stopped;
    result.render_seconds = seconds_since(render_start);
    return result;
}

}  // namespace pxm::host::wide
