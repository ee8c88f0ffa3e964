#include "host/commands/render_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>

#include "host/error.hpp"
#include "host/files/safe_file.hpp"
#include "host/output/image.hpp"
#include "host/output/statistics_json.hpp"
#include "host/parts/claim_run.hpp"
#include "host/parts/join.hpp"
#include "host/parts/keep.hpp"
#include "host/parts/part_choice.hpp"
#include "host/parts/part_run.hpp"
#include "host/process/interrupt.hpp"
#include "host/process/limits.hpp"
#include "host/process/phase_clock.hpp"
#include "host/process/progress.hpp"
#include "host/process/terminal.hpp"
#include "host/render/exposure.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace {

const Environment environment = [](const char* name) { return std::getenv(name); };

/// Parts of another picture in the folder are an error: better now than when all is rendered.
void require_same_picture(const std::string& folder, const PartHeading& heading) {
    std::string why;
    const std::vector<std::string> paths = part_paths(folder);
    if (paths.empty()) return;
    if (const auto part = find_part(paths.front(), why)) PartSet(heading).add(paths.front(), *part);
}

Metadata metadata_of(const PartsRequest& request, const StartedRender& started) {
    return request.metadata(started.result, request.render.frame);
}

}  // namespace

void require_no_stats(const PartsRequest& request, const char* option) {
    if (request.stats.empty()) return;
    throw Error(ErrorKind::setting,
                fmt::format("--stats: a part has none of its own with {}; pxm join --stats {} "
                            "writes those of the picture",
                            option, printable_path(request.stats)));
}

PartChoice part_choice_of(const std::string& part) { return choose_part(part, environment); }

bool is_part_there(const std::string& path, const PartHeading& heading) {
    std::string why;
    const auto part = find_part(path, why);
    if (part) PartSet(heading).add(path, *part);
    const bool there = part.has_value();
    if (!why.empty()) tell(fmt::format("warning: {}: it is made again\n", why));
    return there;
}

// The moments of an open shutter are renders of their own: they have no units.
std::unique_ptr<StartedRender> start_parts(const RenderRequest& request) {
    auto started = start_render(request);
    if (has_exposure(request, started->prepared.scene))
        throw Error(ErrorKind::setting,
                    "a frame with an open shutter is not cut into parts (--set "
                    "animation.shutter=0, or several --frames, each of which is a part)");
    return started;
}

ExitCode render_one_part(const PartsRequest& request, const std::string& part,
                         const std::string& folder) {
    const PartChoice choice = part_choice_of(part);
    require_no_stats(request, "--part");
    if (folder.empty()) throw Error(ErrorKind::setting, "--part: expected -o DIR, for the part");
    make_part_folder(folder);
    const std::string name = part_name(choice.part, choice.parts);
    const std::string path = (std::filesystem::path(folder) / name).string();
    RenderRequest render = request.render;
    render.outputs = {path};
    const auto started = start_parts(render);
    tell(started->result.warnings);
    PartHeading heading =
        heading_of(*started, request.render, request.channels, metadata_of(request, *started));
    heading.part = choice.part;
    heading.parts = choice.parts;
    require_same_picture(folder, heading);
    if (is_part_there(path, heading)) {
        if (!request.quiet) tell(fmt::format("{} is there already\n", name));
        return ExitCode::done;
    }
    const std::size_t units = units_of(heading.grid).size();
    const auto wanted = units_of_part(units, choice.part, choice.parts);
    const bool done = with_progress(request.quiet, [&](const RunControl& control) {
        return write_part({*started, heading, control}, wanted, path);
    });
    if (!done) return exit_code_of_stop("the part was not written");
    if (!request.quiet) {
        tell(fmt::format("{}: {} of {} units in {:.2f} s\n", name, wanted.size(), units,
                         started->result.statistics.seconds.render));
    }
    return ExitCode::done;
}

ExitCode render_claimed(const PartsRequest& request, const std::string& folder,
                        const std::string& parts, double expiry_seconds) {
    const long count = parts.empty() ? 0 : choose_count(parts);
    require_no_stats(request, "--claim");
    make_part_folder(folder);
    const auto started = start_parts(request.render);
    tell(started->result.warnings);
    PartHeading heading =
        heading_of(*started, request.render, request.channels, metadata_of(request, *started));
    const std::size_t units = units_of(heading.grid).size();
    heading.parts = count == 0 ? default_parts(units) : count;
    require_same_picture(folder, heading);
    ClaimedParts claimed{
        folder, {}, std::chrono::milliseconds(std::lround(expiry_seconds * 1000)), {}};
    const long used = std::min(heading.parts, static_cast<long>(units));  // others are empty
    for (long part = 1; part <= used; ++part)
        claimed.names.push_back(part_name(part, heading.parts));
    std::size_t made = 0;
    const bool done = with_progress(request.quiet, [&](const RunControl& control) {
        claimed.make = [&](std::size_t i) {
            heading.part = static_cast<long>(i) + 1;
            const auto wanted = units_of_part(units, heading.part, heading.parts);
            const std::string path = (std::filesystem::path(folder) / claimed.names[i]).string();
            return write_part({*started, heading, control}, wanted, path);
        };
        made = make_claimed_parts(claimed, control);
        return !*control.stop;
    });
    if (!request.quiet) {
        tell(fmt::format("{} of {} parts made here in {:.2f} s\n", made, heading.parts,
                         started->result.statistics.seconds.render));
    }
    return done ? ExitCode::done : exit_code_of_stop(goes_on);
}

ExitCode render_keeping(const PartsRequest& request, const std::string& folder,
                        const std::string& out) {
    const auto start = std::chrono::steady_clock::now();
    require_image_format(out, request.channels);
    const auto started = start_parts(request.render);
    make_part_folder(folder);
    const PartHeading heading =
        heading_of(*started, request.render, request.channels, metadata_of(request, *started));
    std::string warnings = started->result.warnings;
    PartSet parts = kept_parts(folder, heading, warnings);
    tell(warnings);
    const std::size_t units = parts.units().size(), missing = parts.missing().size();
    if (missing < units && !request.quiet)
        tell(fmt::format("{} of {} units are there already\n", units - missing, units));
    const bool done = with_progress(request.quiet, [&](const RunControl& control) {
        return render_missing({*started, heading, control}, folder, parts);
    });
    PhaseClock clock;
    std::optional<JoinedPicture> picture;
    if (done) {
        picture = with_progress(
            request.quiet, [&](const RunControl& control) { return join(parts, out, control); });
    }
    if (!picture) {
        if (!request.quiet) tell("stopped; the same command goes on from here\n");
        return exit_code_of_stop(goes_on);
    }
    tell(picture->warnings);
    Statistics statistics = picture->statistics;
    statistics.seconds = started->result.statistics.seconds;
    statistics.seconds.write = clock.lap();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    statistics.seconds.total = took.count();
    statistics.threads = request.render.threads;
    statistics.threads_because = request.render.threads_because;
    if (!request.stats.empty()) write_text_safely(request.stats, statistics_json(statistics));
    if (!request.quiet) {
        const CropWindow& window = heading.grid.window;
        tell(fmt::format("{}: {}x{} in {:.2f} s\n", printable_path(out), window.x1 - window.x0,
                         window.y1 - window.y0, took.count()));
    }
    return ExitCode::done;
}

}  // namespace pxm::host
