#include "host/wide/wide_engine.hpp"

#include <omp.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <vector>

#include "host/render/first_failure.hpp"
#include "host/render/scene_block.hpp"
#include "host/render/threads.hpp"
#include "host/wide/tile_tracer.hpp"

namespace pxm::host::wide {

namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Tiles that one thread renders one after another: their first pixels, and one beyond the last.
struct TileBlock {
    long x0, y0, x1, y1;
};

/// Blocks of the crop window, those of a part of the picture (host/wide/aspect.hpp) one after
/// another, so that a thread makes few aspects.
std::vector<TileBlock> blocks_of_tiles(const CropWindow& crop, long part, long threads) {
    constexpr long most_side = 8 * tile_side, least_side = 2 * tile_side;
    constexpr long blocks_a_thread = 16;
    const long pixels = (crop.x1 - crop.x0) * (crop.y1 - crop.y0);
    long side = std::min(part, most_side);
    while (side / 2 >= least_side && pixels < blocks_a_thread * threads * side * side) side /= 2;
    side = side / tile_side * tile_side;
    const auto first_tile = [](long pixel) { return pixel / tile_side * tile_side; };
    std::vector<TileBlock> blocks;
    for (long part_y = crop.y0 / part * part; part_y < crop.y1; part_y += part) {
        for (long part_x = crop.x0 / part * part; part_x < crop.x1; part_x += part) {
            for (long y = part_y; y < part_y + part; y += side) {
                for (long x = part_x; x < part_x + part; x += side) {
                    const TileBlock block{std::max(x, first_tile(crop.x0)),
                                          std::max(y, first_tile(crop.y0)),
                                          std::min({x + side, part_x + part, crop.x1}),
                                          std::min({y + side, part_y + part, crop.y1})};
                    if (block.x0 < block.x1 && block.y0 < block.y1) blocks.push_back(block);
                }
            }
        }
    }
    return blocks;
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
    const std::vector<TileBlock> blocks =
        blocks_of_tiles(scene.crop, wide.aspect_side, choice.threads);
    std::atomic<long> done = 0;
    std::atomic<bool> stopped = false;
    FirstFailure failure;
    const int threads = threads_that_start(choice.threads);
#pragma omp parallel num_threads(threads)
    {
        std::optional<TileTracer> tracer;
        failure.guard([&] { tracer.emplace(scene, wide, rest, block, result.frame); });
#pragma omp for schedule(dynamic) nowait
        for (std::size_t i = 0; i < blocks.size(); ++i) {
            failure.guard([&] {
                const TileBlock& tiles = blocks[i];
                for (long top = tiles.y0; top < tiles.y1; top += tile_side) {
                    for (long left = tiles.x0; left < tiles.x1; left += tile_side) {
                        if (control.stop && *control.stop) stopped = true;
                        if (!stopped.load(std::memory_order_relaxed)) tracer->render(left, top);
                    }
                }
                const long finished = ++done;
                if (control.progress && omp_get_thread_num() == 0) {
                    control.progress(static_cast<double>(finished) /
                                     static_cast<double>(blocks.size()));
                }
            });
        }
        failure.guard([&] {
            const RayStatistics rays = tracer->finish();
#pragma omp critical(pxm_wide_sum)
            result.rays.add(rays);
        });
    }
    failure.rethrow();
    result.stopped = stopped;
    result.render_seconds = seconds_since(render_start);
    return result;
}

}  // namespace pxm::host::wide
