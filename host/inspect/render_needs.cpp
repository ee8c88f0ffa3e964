#include "host/inspect/render_needs.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <vector>

#include "host/output/row_bands.hpp"
#include "host/render/exposure.hpp"
#include "host/render/start.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace {

constexpr long square_side = 4 * tile_side;  // so that what a run costs beside its pixels is little
constexpr long most_squares = 16 * 16;
constexpr double trial_cpu_seconds = 1;  // then there need to be `least_squares` only
constexpr std::size_t least_squares = 12;

double cpu_seconds_now() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    constexpr double nanosecond = 1e-9;
    return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * nanosecond;
}

std::uint64_t most_memory_until_now() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;  // it is in KiB
}

/// Squares on a lattice of two irrational steps: any beginning of the list is spread evenly.
std::vector<CropWindow> squares_of(const CropWindow& window) {
    constexpr double step_x = 0.7548776662466927,
                     step_y = 0.5698402909980532;  // R2, of x^3 = x + 1
    const long columns = (window.x1 - window.x0 + square_side - 1) / square_side;
    const long rows = (window.y1 - window.y0 + square_side - 1) / square_side;
    const long count = std::min(most_squares, (columns * rows + 1) / 2);
    std::vector<CropWindow> squares;
    for (long i = 0; i < count; ++i) {
        const auto at = [&](double step, long cells) {
            const double place = (static_cast<double>(i) + 0.5) * step;
            return static_cast<long>((place - std::floor(place)) * static_cast<double>(cells));
        };
        const long x = window.x0 + at(step_x, columns) * square_side;
        const long y = window.y0 + at(step_y, rows) * square_side;
        squares.push_back(
            {x, y, std::min(x + square_side, window.x1), std::min(y + square_side, window.y1)});
    }
    return squares;
}

/// What the file's making keeps beside the engine: two bands of rows, with 16 bytes a pixel at
/// most, and as much again while they are packed.
std::uint64_t bytes_of_bands(const CropWindow& window) {
    constexpr std::uint64_t pixel_bytes = 16, bands = 4;
    return static_cast<std::uint64_t>(window.x1 - window.x0) * band_rows * pixel_bytes * bands;
}

}  // namespace

std::optional<RenderNeeds> render_needs(const RenderRequest& request,
                                        const std::atomic<bool>& stop) {
    RenderRequest trial = request;
    trial.threads = 1;  // squares are too small to be shared
    const std::unique_ptr<StartedRender> started = start_render(trial);
    const double before = cpu_seconds_now();  // since the process began
    const CropWindow& window = started->result.window;
    const RunControl control{&stop, nullptr};
    RenderNeeds needs{
        request.scene_path, started->result.statistics.size, 0, 0, request.threads, 0, 0};
    std::size_t squares = 0;
    for (const CropWindow& square : squares_of(window)) {
        if (squares >= least_squares && cpu_seconds_now() - before > trial_cpu_seconds) break;
        if (started->loaded->run(square, control).stopped) return std::nullopt;
        needs.trial_pixels += (square.x1 - square.x0) * (square.y1 - square.y0);
        ++squares;
    }
    const auto pixels = static_cast<double>((window.x1 - window.x0) * (window.y1 - window.y0));
    double rays = (cpu_seconds_now() - before) * pixels / static_cast<double>(needs.trial_pixels);
    needs.bytes = most_memory_until_now() + bytes_of_bands(window);
    const Scene& scene = started->prepared.scene;
    if (has_exposure(request, scene)) {  // a render of all pixels for every moment, kept whole
        rays *= static_cast<double>(scene.render->samples.value_or(1));
        constexpr double sums_bytes = 32;
        needs.bytes += static_cast<std::uint64_t>(pixels * (2 * sizeof(PixelRecord) + sums_bytes));
    }
    needs.cpu_seconds = before + rays;
    needs.seconds = before + rays / request.threads;
    return needs;
}

std::string render_needs_text(const RenderNeeds& needs) {
    return fmt::format(
        "{}\n\na native render of {}x{} pixels, as {} of them say\n  {:<20} {:.2g} with {} "
        "thread{}\n  {:<20} {:.2g}\n  {:<20} {:.2g} million\n",
        printable_path(needs.scene), needs.size.columns, needs.size.rows, needs.trial_pixels,
        "seconds", needs.seconds, needs.threads, needs.threads == 1 ? "" : "s", "seconds of cores",
        needs.cpu_seconds, "bytes of memory", static_cast<double>(needs.bytes) / 1e6);
}

}  // namespace pxm::host
