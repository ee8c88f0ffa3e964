// What the threads of pxm share, without what they compute: the loop of tiles as the native and the
// wide engine have it, with a taker that puts blocks in order, progress and a stop; nodes of the
// machine with somebody who looks on; steps that threads share; the studio's turns and jobs; the
// watch over the limits of a run, beside a signal. What is shared in the engines' data is tried
// with the whole program, where there is a build of it (run).
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "host/engine/node_watch.hpp"
#include "host/engine/tiles.hpp"
#include "host/error.hpp"
#include "host/process/in_order.hpp"
#include "host/process/in_threads.hpp"
#include "host/process/interrupt.hpp"
#include "host/process/limits.hpp"
#include "host/process/progress.hpp"
#include "host/studio/jobs.hpp"
#include "host/studio/turns.hpp"
#include "pxm/scheduler.hpp"

using namespace pxm;
using namespace pxm::host;

namespace {

constexpr long columns = 203, rows = 77;  // tiles that are cut at the window's edges

struct Tracer {
    RayStatistics rays;
    void render(Frame& frame, long left, long top, const GoOn& go_on) {
        if (!go_on()) return;
        const long right = std::min(left + tile_side, frame.crop.x1);
        const long bottom = std::min(top + tile_side, frame.crop.y1);
        for (long y = std::max(top, frame.crop.y0); y < bottom; ++y)
            for (long x = std::max(left, frame.crop.x0); x < right; ++x)
                frame.at(x, y).z = static_cast<float>(x * y);
    }
    RayStatistics finish() const { return rays; }
};

bool is_right(const Frame& frame) {
    for (long y = frame.crop.y0; y < frame.crop.y1; ++y)
        for (long x = frame.crop.x0; x < frame.crop.x1; ++x)
            if (frame.at(x, y).z != static_cast<float>(x * y)) return false;
    return true;
}

/// One frame for all, and a frame a block, with and without a stop in the middle.
bool tiles() {
    const CropWindow window{3, 2, columns, rows};
    const TileJob job{{columns, rows}, window, 32, 4};
    const auto make = [] { return std::make_unique<Tracer>(); };
    bool good = is_right(run_tiles(job, {}, nullptr, make).frame);
    for (const double end : {2.0, 0.3}) {
        std::atomic<bool> stop = false;
        Progress bar(true);
        const RunControl control{&stop, [&](double share) {
                                     bar.update(share);
                                     if (share > end) stop = true;
                                 }};
        InOrder<Frame> order;
        std::atomic<long> number = 0;
        long taken = 0;
        const BlockTaker taker{[&](Frame& frame) {
                                   const bool right = is_right(frame);
                                   order.add(number++, frame, [&](Frame& next) {
                                       taken += (next.crop.x1 - next.crop.x0) *
                                                (next.crop.y1 - next.crop.y0);
                                   });
                                   if (!right) std::abort();
                               },
                               16};
        const EngineResult result = run_tiles(job, control, &taker, make);
        const long all = (window.x1 - window.x0) * (window.y1 - window.y0);
        good = good && (result.stopped ? taken <= all : taken == all);
    }
    return good;
}

bool units() {
    const UnitGrid grid = grid_of_tiles({0, 0, columns, rows}, 32);
    const std::vector<UnitPixels> all = units_of(grid);
    std::vector<std::size_t> wanted(all.size());
    for (std::size_t i = 0; i < all.size(); ++i) wanted[i] = i;
    std::atomic<std::size_t> taken = 0;
    const TakeUnit take = [&](const FinishedUnit& unit) { taken += unit.pixels.size(); };
    (void)run_tile_units({columns, rows}, {all, wanted, take}, 4, {},
                         [] { return std::make_unique<Tracer>(); });
    return taken == static_cast<std::size_t>(columns * rows);
}

bool nodes() {
    NodeWatch watch(64);
    std::atomic<bool> over = false;
    std::uint64_t seen = 0;
    std::jthread looking([&] {
        while (!over)
            for (const NodeWatch::Seen& node : watch.nodes()) seen += node.cycles;
    });
    for_each_node(64, 4, [&](int node) {
        for (std::uint64_t i = 0; i < 200; ++i) watch.tell(static_cast<std::size_t>(node), i);
    });
    over = true;
    looking.join();
    std::vector<int> made(1000);
    const std::atomic<bool> stop = false;
    const bool all = in_threads(4, made.size(), stop, [&](std::size_t i) { made[i] = 1; });
    return all && std::ranges::count(made, 1) == 1000;
}

void ask(Turns& turns, Jobs& jobs, std::uint64_t serial, std::atomic<int>& answered) {
    const std::string view = serial % 2 == 0 ? "one" : "two";
    const std::optional<Turns::Turn> turn = turns.take(view, serial);
    if (turn) {
        const std::shared_ptr<Job> job = jobs.begin(view, 64);
        for (int i = 0; i < 200 && !turn->stop(); ++i) {
            job->share = i / 200.0;
            job->watch.tell(3, static_cast<std::uint64_t>(i));
            std::this_thread::sleep_for(std::chrono::microseconds(100));
        }
        (void)turn->stopping_milliseconds();
    }
    ++answered;
}

/// Pages that ask faster than they are answered, leave, and are closed.
bool studio() {
    constexpr std::uint64_t requests = 60;
    Turns turns(1);
    Jobs jobs;
    std::atomic<int> answered = 0;
    std::atomic<bool> over = false;
    std::jthread looking([&] {
        double sum = 0;
        while (!over)
            if (const auto job = jobs.find("one")) sum += job->share;
    });
    {
        std::vector<std::jthread> threads;
        for (std::uint64_t serial = 1; serial <= requests; ++serial) {
            threads.emplace_back([&, serial] { ask(turns, jobs, serial, answered); });
            if (serial % 7 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(5));
            if (serial == requests / 2) turns.leave("two");
        }
        turns.close();
    }
    over = true;
    return answered == static_cast<int>(requests);
}

/// A limit that is not reached, one that is, and a signal beside.
bool limits() {
    catch_signals();
    { const LimitWatch watch({1000.0, std::nullopt}); }
    const LimitWatch watch({0.05, std::nullopt});
    std::vector<int> made(4);
    (void)in_threads(4, 1'000'000, stop_requested(), [&](std::size_t) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    });
    return exit_code_of_stop("a trial") == ExitCode::parts_missing;
}

}  // namespace

int main() {
    bool good = true;
    for (const auto& [name, trial] : {std::pair{"tiles", &tiles},
                                      {"units", &units},
                                      {"nodes", &nodes},
                                      {"studio", &studio},
                                      {"limits", &limits}}) {
        const bool right = trial();
        std::printf("%s: %s\n", name, right ? "right" : "wrong");
        good = good && right;
    }
    return good ? 0 : 1;
}
