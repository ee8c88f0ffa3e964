// How native renders share a window among threads: blocks of 8x8 tiles, taken by whoever is free. A
// tile is one pixel of each of the 64 nodes of a 964, seen from the other side.
#pragma once

#include <omp.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <limits>
#include <vector>

#include "host/engine/engine.hpp"
#include "host/engine/threads.hpp"
#include "host/engine/units.hpp"
#include "host/process/first_failure.hpp"
#include "host/process/phase_clock.hpp"

namespace pxm::host {

/// Tiles that one thread renders one after another: the first pixels of the first tile, and one
/// pixel beyond the last tile. It may reach out of the window where tiles do.
struct TileBlock {
    long x0, y0, x1, y1;
};

/// The blocks of a window. Those of one part of the image, a square of `part` pixels counted from
/// the image's corner, come one after another, and there are enough of them for all threads. Parts
/// that are higher than `band_rows` are cut, so that blocks come by bands of rows. Precondition:
/// `part` and `band_rows` are multiples of tile_side.
[[nodiscard]] std::vector<TileBlock> blocks_of_tiles(const CropWindow& window, long part,
                                                     long band_rows, long threads);

/// What of a block lies in the window.
[[nodiscard]] inline CropWindow part_of(const TileBlock& block, const CropWindow& window) {
    return {std::max(block.x0, window.x0), std::max(block.y0, window.y0),
            std::min(block.x1, window.x1), std::min(block.y1, window.y1)};
}

/// The same blocks of parts that are `part_rows` high, with a side that is given, another multiple
/// of tile_side.
[[nodiscard]] std::vector<TileBlock> blocks_of_side(const CropWindow& window, long part,
                                                    long part_rows, long side);

/// False when the run is given up: tracers that take long for a tile ask now and then.
using GoOn = std::function<bool()>;

/// A window of an image that is rendered by threads.
struct TileJob {
    PixelSize size;  // of the image
    CropWindow window;
    long part = 0;  // of blocks_of_tiles()
    int threads = 1;
};

/// Renders a window with OpenMP. `make_tracer()` points to what one thread renders with and is
/// called in that thread; `tracer->render(frame, left, top, go_on)` renders those pixels of the
/// tile that begins there which lie in the frame, whose pixels are as new, and `tracer->finish()`
/// returns what it counted since it was last asked. With a taker each thread has a frame for its
/// block, which stays in its cache; without, all write to that of the result.
template <class MakeTracer>
EngineResult run_tiles(const TileJob& job, const RunControl& control, const BlockTaker* taker,
                       const MakeTracer& make_tracer) {
    constexpr long all_rows = std::numeric_limits<long>::max() / 2 / tile_side * tile_side;
    const std::vector<TileBlock> blocks =
        blocks_of_tiles(job.window, job.part, taker ? taker->band_rows : all_rows, job.threads);
    EngineResult result;
    if (!taker) result.frame = Frame(job.size, job.window);
    PhaseClock clock;
    std::atomic<long> done = 0;
    std::atomic<bool> stopped = false;
    const GoOn go_on = [&] {
        if (control.stop && *control.stop) stopped = true;
        return !stopped.load(std::memory_order_relaxed);
    };
    FirstFailure failure;
    const int team = threads_that_start(job.threads);
#pragma omp parallel num_threads(team)
    {
        decltype(make_tracer()) tracer;
        Frame own;
        double take_seconds = 0;
        failure.guard([&] { tracer = make_tracer(); });
#pragma omp for schedule(dynamic) nowait
        for (std::size_t i = 0; i < blocks.size(); ++i) {
            failure.guard([&] {
                const TileBlock& block = blocks[i];
                if (taker) own.renew(job.size, part_of(block, job.window));
                Frame& frame = taker ? own : result.frame;
                for (long top = block.y0; top < block.y1; top += tile_side) {
                    for (long left = block.x0; left < block.x1; left += tile_side) {
                        if (go_on()) tracer->render(frame, left, top, go_on);
                    }
                }
                if (taker && go_on()) {
                    PhaseClock take_clock;
                    taker->take(frame);
                    take_seconds += take_clock.lap();
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
            {
                result.rays.add(rays);  // integers: the sum does not depend on the order
                result.take_seconds += take_seconds / team;
            }
        });
    }
    failure.rethrow();
    result.stopped = stopped;
    result.render_seconds = clock.lap() - result.take_seconds;
    return result;
}

/// Renders units in the same way, each in a frame of its own that is given to `take` when all of
/// it is there.
template <class MakeTracer>
UnitsRun run_tile_units(const PixelSize& image, const UnitWork& work, int threads,
                        const RunControl& control, const MakeTracer& make_tracer) {
    PhaseClock clock;
    std::atomic<std::size_t> done = 0;
    std::atomic<bool> stopped = false;
    const GoOn go_on = [&] {
        if (control.stop && *control.stop) stopped = true;
        return !stopped.load(std::memory_order_relaxed);
    };
    FirstFailure failure;
    const int team = threads_that_start(threads);
#pragma omp parallel num_threads(team)
    {
        Frame frame;
        decltype(make_tracer()) tracer;
        failure.guard([&] { tracer = make_tracer(); });
#pragma omp for schedule(dynamic) nowait
        for (std::size_t i = 0; i < work.wanted.size(); ++i) {
            failure.guard([&] {
                const UnitPixels& unit = work.units[work.wanted[i]];
                frame.renew(image, {unit.x0, unit.y0, unit.x1, unit.y1});
                for (long top = unit.y0 / tile_side * tile_side; top < unit.y1; top += tile_side) {
                    for (long left = unit.x0 / tile_side * tile_side; left < unit.x1;
                         left += tile_side) {
                        if (go_on()) tracer->render(frame, left, top, go_on);
                    }
                }
                const RayStatistics rays = tracer->finish();
                if (!go_on()) return;  // it may be incomplete
                work.take({work.wanted[i], frame.pixels, rays});
                const std::size_t finished = ++done;
                if (control.progress && omp_get_thread_num() == 0) {
                    control.progress(static_cast<double>(finished) /
                                     static_cast<double>(work.wanted.size()));
                }
            });
        }
    }
    failure.rethrow();
    return {clock.lap(), stopped};
}

}  // namespace pxm::host
