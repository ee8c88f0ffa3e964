#include "host/parts/keep.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <optional>

#include "host/error.hpp"
#include "host/parts/heading_json.hpp"
#include "host/parts/kept_batches.hpp"

namespace pxm::host {

namespace fs = std::filesystem;

namespace {

/// Reads all of a part, so that nothing damaged is found when it is too late to render it again.
PartReader whole_part(const std::string& path) {
    PartReader part(path);
    const RegularFile file(path);
    for (const UnitEntry& entry : part.entries()) (void)read_payload(file, entry);
    return part;
}

}  // namespace

PartSet kept_parts(const std::string& folder, const PartHeading& heading, std::string& warnings) {
    PartSet parts(heading);
    for (const std::string& path : part_paths(folder)) {
        std::optional<PartReader> part;
        try {
            part = whole_part(path);
        } catch (const Error& error) {
            warnings += fmt::format("warning: {}: what it holds is rendered again\n", error.what());
        }
        if (part) parts.add(path, *part);
    }
    return parts;
}

bool render_missing(const UnitRender& render, const std::string& folder, PartSet& parts) {
    const std::vector<std::size_t> wanted = parts.missing();
    if (wanted.empty()) return true;
    KeptBatches waiting(folder, heading_json(render.heading));
    const TakeUnit take = [&](const FinishedUnit& unit) {
        const AlarmSums alarms = mark_alarms(render.heading.alarms, unit.pixels);
        waiting.add(unit.index, payload_of(unit, alarms, render.heading.channels));
    };
    const UnitsRun run = render.started.loaded->run_units(
        render.heading.grid, {parts.units(), wanted, take}, render.control);
    render.started.result.statistics.seconds.render += run.render_seconds;
    waiting.write_rest();
    for (const std::string& path : waiting.paths()) parts.add(path);
    return !run.stopped;
}

}  // namespace pxm::host
