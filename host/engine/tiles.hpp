// How native renders share a window among threads: blocks of 8x8 tiles, taken by whoever is free. A
// tile is one pixel of each of the 64 nodes of a 964, seen from the other side.
#pragma once

#include <omp.h>

#include <atomic>
#include <functional>
#include <vector>

#include "host/engine/engine.hpp"
#include "host/engine/threads.hpp"
#include "host/process/first_failure.hpp"
#include "host/process/phase_clock.hpp"

namespace pxm::host {

/// Tiles that one thread renders one after another: the first pixels of the first tile, and one
/// pixel beyond the last tile. It may reach out of the window where tiles do.
struct TileBlock {
    long x0, y0, x1, y1;
};

/// The blocks of a window. Those of one part of the image, a square of `part` pixels counted from
/// the image's corner, come one after another, and there are enough of them for all threads.
/// Precondition: `part` is a multiple of tile_side.
[[nodiscard]] std::vector<TileBlock> blocks_of_tiles(const CropWindow& window, long part,
                                                     long threads);

/// False when the run is given up: tracers that take long for a tile ask now and then.
using GoOn = std::function<bool()>;

/// Renders blocks with OpenMP. `make_tracer()` points to what one thread renders with and is called
/// in that thread; `tracer->render(left, top, go_on)` renders the tile that begins there, and
/// `tracer->finish()` returns the thread's counts. Fills in all of `result` but the frame, which
/// the tracers write to.
template <class MakeTracer>
void run_tiles(const std::vector<TileBlock>& blocks, int threads, const RunControl& control,
               EngineResult& result, const MakeTracer& make_tracer) {
    PhaseClock clock;
    std::atomic<long> done = 0;
    std::atomic<bool> stopped = false;
    const GoOn go_on = [&] {
        if (control.stop && *control.stop) stopped = true;
        return !stopped.load(std::memory_order_relaxed);
    };
    FirstFailure failure;
    const int team = threads_that_start(threads);
#pragma omp parallel num_threads(team)
    {
        decltype(make_tracer()) tracer;
        failure.guard([&] { tracer = make_tracer(); });
#pragma omp for schedule(dynamic) nowait
        for (std::size_t i = 0; i < blocks.size(); ++i) {
            failure.guard([&] {
                const TileBlock& block = blocks[i];
                for (long top = block.y0; top < block.y1; top += tile_side) {
                    for (long left = block.x0; left < block.x1; left += tile_side) {
                        if (go_on()) tracer->render(left, top, go_on);
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
#pragma omp critical(pxm_tile_sum)
            result.rays.add(rays);  // integers: the sum does not depend on the order
        });
    }
    failure.rethrow();
    result.stopped = stopped;
    result.render_seconds = clock.lap();
}

}  // namespace pxm::host
