// The native engine: OpenMP threads take 8x8 tiles. A tile is one pixel of each of the 64 nodes of
// a 964, seen from the other side.
#include <omp.h>

#include <algorithm>
#include <chrono>
#include <optional>

#include "host/render/crowded.hpp"
#include "host/render/engine.hpp"
#include "host/render/first_failure.hpp"
#include "host/render/gather.hpp"
#include "host/render/instances.hpp"
#include "host/render/threads.hpp"
#include "host/wide/wide_engine.hpp"
#include "pxm/frame_buffer.hpp"

namespace pxm::host {

namespace {

constexpr long tile_side = 8;

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The part of tile number `tile` (row by row over the window's tiles) that lies in the window.
kernels::PixelShare tile_share(const CropWindow& window, long tiles_across, long tile) {
    const long left = window.x0 / tile_side * tile_side + tile % tiles_across * tile_side;
    const long top = window.y0 / tile_side * tile_side + tile / tiles_across * tile_side;
    const auto pixel = [](long v) { return static_cast<std::uint32_t>(v); };
    return {pixel(std::max(left, window.x0)),
            pixel(std::max(top, window.y0)),
            pixel(std::min(left + tile_side, window.x1)),
            pixel(std::min(top + tile_side, window.y1)),
            1,
            1};
}

/// Tiles that a half-open range of pixels touches.
long tiles_touched(long from, long to) {
    return (to + tile_side - 1) / tile_side - from / tile_side;
}

template <class Real, kernels::Features features>
EngineResult run(const CompiledScene& scene, const EngineChoice& choice,
                 const RunControl& control) {
    const auto start = std::chrono::steady_clock::now();
    EngineResult result;
    const std::vector<std::uint32_t> block = make_scene_block<Real>(scene);
    result.frame = Frame(scene.size, scene.crop);
    result.scene_block_words = block.size();
    result.scene_block_hash = block_hash(block);
    result.load_seconds = seconds_since(start);

    const auto render_start = std::chrono::steady_clock::now();
    const Model& model = *find_model("964");  // for the `node` channel
    const long across = tiles_touched(scene.crop.x0, scene.crop.x1);
    const long tiles = across * tiles_touched(scene.crop.y0, scene.crop.y1);
    std::atomic<long> done = 0;
    std::atomic<bool> stopped = false;
    FirstFailure failure;
    const int threads = threads_that_start(choice.threads);
#pragma omp parallel num_threads(threads)
    {
        RayStatistics rays;
        std::optional<NativeNode<Real>> node;
        failure.guard([&] { node.emplace(make_native_node<NativeNode<Real>>(scene, block)); });
        clear_overflow();  // a thread keeps the flags of what it computed before
#pragma omp for schedule(dynamic, 4) nowait
        for (long tile = 0; tile < tiles; ++tile) {
            if (stopped.load(std::memory_order_relaxed)) continue;
            failure.guard([&] {
                kernels::pixel_program<features>(
                    *node, tile_share(scene.crop, across, tile),
                    [&](std::uint32_t x, std::uint32_t y, const kernels::PixelResult<Real>& pixel) {
                        PixelRecord& record = result.frame.at(x, y);
                        gather_pixel(scene, block, pixel, record, rays);
                        const NodeId id = owner(model, static_cast<int>(x), static_cast<int>(y));
                        record.node =
                            static_cast<std::uint16_t>(id.row * model.columns + id.column);
                        if (control.stop && *control.stop) stopped = true;
                        return !stopped;
                    });
                const long finished = ++done;
                if (control.progress && omp_get_thread_num() == 0) {
                    control.progress(static_cast<double>(finished) / static_cast<double>(tiles));
                }
            });
        }
#pragma omp critical(pxm_native_sum)
        result.rays.add(rays);  // integers: the sum does not depend on the order
    }
    failure.rethrow();
    result.stopped = stopped;
    result.render_seconds = seconds_since(render_start);
    return result;
}

}  // namespace

EngineResult run_natively(const CompiledScene& scene, const EngineChoice& choice,
                          const RunControl& control) {
    if (choice.intersect == IntersectMethod::wide) return wide::run_wide(scene, choice, control);
    return with_instance(scene, choice.numeric, [&]<class Real, kernels::Features features>() {
        return run<Real, features>(scene, choice, control);
    });
}

}  // namespace pxm::host
