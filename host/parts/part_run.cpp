#include "host/parts/part_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <span>
#include <system_error>
#include <utility>

#include "host/error.hpp"
#include "host/files/new_folder.hpp"
#include "host/parts/part_file.hpp"
#include "host/process/in_order.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace fs = std::filesystem;

long part_of_unit(std::size_t unit, std::size_t units, long parts) {
    constexpr std::size_t stretches = 32;  // a part has, at least, where there are so many units
    const auto count = static_cast<std::size_t>(parts);
    const std::size_t stretch = std::max<std::size_t>(1, units / count / stretches);
    return static_cast<long>(unit / stretch % count) + 1;
}

std::vector<std::size_t> units_of_part(std::size_t units, long part, long parts) {
    std::vector<std::size_t> own;
    for (std::size_t unit = 0; unit < units; ++unit)
        if (part_of_unit(unit, units, parts) == part) own.push_back(unit);
    return own;
}

std::string part_name(long part, long parts) {
    const std::string all = std::to_string(parts);
    return fmt::format("part-{:0{}}-of-{}{}", part, all.size(), all, part_ending);
}

bool write_part(const UnitRender& render, const std::vector<std::size_t>& wanted,
                const std::string& path) {
    PartWriter file(path, render.heading);
    // Units come from the threads in any order and go to the file in theirs, so that a part made
    // twice is the same file.
    InOrder<std::pair<std::size_t, std::string>> order;
    const std::vector<UnitPixels> units = units_of(render.heading.grid);
    const TakeUnit take = [&](const FinishedUnit& unit) {
        const AlarmSums alarms = mark_alarms(render.heading.alarms, unit.pixels);
        const auto place = std::ranges::lower_bound(wanted, unit.index) - wanted.begin();
        order.add(place, {unit.index, payload_of(unit, alarms, render.heading.channels)},
                  [&](const auto& next) { file.add(next.first, next.second); });
    };
    const UnitsRun run = render.started.loaded->run_units(render.heading.grid,
                                                          {units, wanted, take}, render.control);
    render.started.result.statistics.seconds.render += run.render_seconds;
    if (run.stopped) return false;
    file.finish();
    return true;
}

namespace {

std::vector<PixelRecord> pixels_of(const UnitPixels& unit, const Frame& frame) {
    std::vector<PixelRecord> pixels;
    pixels.reserve(unit.count());
    for (long y = unit.y0; y < unit.y1; y += unit.step_y)
        for (long x = unit.x0; x < unit.x1; x += unit.step_x) pixels.push_back(frame.at(x, y));
    return pixels;
}

/// Of pixels whose alarms are final: none depends on others any more.
AlarmSums sums_of_marked(std::span<const PixelRecord> pixels) {
    AlarmSums sums;
    for (const PixelRecord& pixel : pixels)
        for (std::size_t bit = 0; bit < sums.of_hits.size(); ++bit)
            sums.of_hits[bit] += pixel.alarms >> bit & 1U;
    return sums;
}

}  // namespace

void write_whole(const RenderResult& picture, const PartHeading& heading, const std::string& path) {
    PartWriter file(path, heading);
    const std::vector<UnitPixels> units = units_of(heading.grid);
    for (std::size_t i = 0; i < units.size(); ++i) {
        std::vector<PixelRecord> pixels = pixels_of(units[i], picture.frame);
        FinishedUnit unit{i, pixels, {}, nullptr};
        if (i == 0) unit.rays = picture.statistics.rays;  // the sum is what counts
        file.add(i, payload_of(unit, sums_of_marked(pixels), heading.channels));
    }
    file.finish();
}

void make_part_folder(const std::string& folder) {
    const std::error_code error = make_folders(folder);
    if (error) {
        throw Error(ErrorKind::file, fmt::format("cannot make the folder {}: {}",
                                                 printable_path(folder), error.message()));
    }
    require_writable((fs::path(folder) / part_name(1, 1)).string());
}

}  // namespace pxm::host
