#include "host/commands/render_film_parts.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "host/commands/join_film.hpp"
#include "host/error.hpp"
#include "host/files/regular_file.hpp"
#include "host/output/spared_inputs.hpp"
#include "host/parts/claim_run.hpp"
#include "host/parts/film_parts.hpp"
#include "host/parts/keep.hpp"
#include "host/process/interrupt.hpp"
#include "host/process/limits.hpp"
#include "host/process/phase_clock.hpp"
#include "host/process/terminal.hpp"
#include "host/render/exposure.hpp"
#include "host/scene/check/settings.hpp"
#include "host/text/digest.hpp"

namespace pxm::host {

namespace {

const std::string whole = part_name(1, 1);  // a frame's only part

/// The digest of all files that the scene is read from, and of what the command line says over it.
std::string source_of(const PartsRequest& request, const Scene& scene) {
    std::string digests = text_of(request.render.settings);
    for (const InputFile& input : inputs_of(scene)) {
        if (!std::filesystem::exists(input.path)) continue;  // it is a --set
        const RegularFile file(input.path);
        digests += fmt::format(" {:016x}", digest_of(file.read(0, file.bytes())));
    }
    return fmt::format("{:016x}", digest_of(digests));
}

/// A film of which frames are made, in the folder for its parts.
class Film {
  public:
    Film(const FilmRequest& request, const std::string& folder)
        : request_(request), folder_(folder), scene_(scene_of(request.parts.render)) {
        place_ = {0, request.text, scene_.animation->frames, scene_.animation->rate,
                  source_of(request.parts, scene_)};
        make_part_folder(folder);
        require_same_film(folder, place_);
    }

    [[nodiscard]] const Scene& scene() const { return scene_; }

    /// A frame that has come to its first ray.
    struct Started {
        std::unique_ptr<StartedRender> render;
        PartHeading heading;
        std::string folder;
    };
    [[nodiscard]] Started start(long frame) {
        RenderRequest render = request_.parts.render;
        render.frame = static_cast<double>(frame);
        Started started{start_render(render), {}, frame_folder(folder_, frame)};
        const RenderResult& known = started.render->result;
        tell_once(frame, known.warnings);
        started.heading = heading_of(*started.render, render, request_.parts.channels,
                                     request_.parts.metadata(known, render.frame));
        started.heading.film = place_;
        started.heading.film->frame = frame;
        make_part_folder(started.folder);
        return started;
    }

    /// Makes a frame's part, unless it is there. False if it was stopped.
    [[nodiscard]] bool make(long frame, const RunControl& control) {
        Started started = start(frame);
        started.heading.part = started.heading.parts = 1;
        const std::string path = (std::filesystem::path(started.folder) / whole).string();
        if (is_part_there(path, started.heading)) return true;
        if (is_exposed()) return expose(frame, started.heading, path, control);
        const auto units = units_of_part(units_of(started.heading.grid).size(), 1, 1);
        return write_part({*started.render, started.heading, control}, units, path);
    }

    /// The same so that what is done of a frame is not lost.
    [[nodiscard]] bool keep(long frame, const RunControl& control) {
        if (is_exposed()) return make(frame, control);
        Started started = start(frame);
        std::string warnings;
        PartSet parts = kept_parts(started.folder, started.heading, warnings);
        tell(warnings);
        return render_missing({*started.render, started.heading, control}, started.folder, parts);
    }

  private:
    [[nodiscard]] bool is_exposed() const { return has_exposure(request_.parts.render, scene_); }

    /// The moments of an open shutter are renders of their own: such a frame is made whole.
    [[nodiscard]] bool expose(long frame, PartHeading heading, const std::string& path,
                              const RunControl& control) {
        RenderRequest render = request_.parts.render;
        render.frame = static_cast<double>(frame);
        const RenderResult result = host::render(render, control);
        if (result.stopped) return false;
        heading.metadata = request_.parts.metadata(result, render.frame);
        for (const Alarm& alarm : result.statistics.alarms) {  // the most of all moments
            if (alarm.name == "steep_maps") heading.alarms.steep_maps = alarm.count;
            if (alarm.name == "flat_maps") heading.alarms.flat_maps = alarm.count;
            if (alarm.name == "range") heading.alarms.maps_out_of_range = alarm.count;
        }
        write_whole(result, heading, path);
        return true;
    }

    /// Frames have the same warnings, most of them.
    void tell_once(long frame, const std::string& warnings) {
        if (!told_ && !warnings.empty()) tell(fmt::format("frame {}: {}", frame, warnings));
        told_ = told_ || !warnings.empty();
    }

    const FilmRequest& request_;
    std::string folder_;
    Scene scene_;
    FilmPlace place_;
    bool told_ = false;
};

/// Calls make(frame, control) for frames; false if it was stopped.
template <class Make>
bool for_frames(const std::vector<long>& frames, const RunControl& control, const Make& make) {
    for (std::size_t i = 0; i < frames.size(); ++i) {
        if (*control.stop) return false;
        const RunControl share = share_of(control, i, frames.size());
        if (!naming_frame(static_cast<double>(frames[i]), [&] { return make(frames[i], share); }))
            return false;
    }
    return true;
}

}  // namespace

ExitCode render_part_of_film(const FilmRequest& request, const std::string& part,
                             const std::string& folder) {
    const PartChoice choice = part_choice_of(part);
    require_no_stats(request.parts, "--part");
    if (folder.empty()) throw Error(ErrorKind::setting, "--part: expected -o DIR, for the part");
    PhaseClock clock;
    Film film(request, folder);
    const auto frames = frames_of_part(request.frames, choice.part, choice.parts);
    const bool done = with_progress(request.parts.quiet, [&](const RunControl& control) {
        return for_frames(frames, control, [&](long frame, const RunControl& share) {
            return film.make(frame, share);
        });
    });
    if (!done) return exit_code_of_stop(goes_on);
    if (!request.parts.quiet)
        tell(fmt::format("{} of {} frames in {:.2f} s\n", frames.size(), request.frames.size(),
                         clock.lap()));
    return ExitCode::done;
}

ExitCode render_claimed_film(const FilmRequest& request, const std::string& folder,
                             double expiry_seconds) {
    require_no_stats(request.parts, "--claim");
    PhaseClock clock;
    Film film(request, folder);
    std::vector<std::string> names;
    for (const long frame : request.frames) {
        make_part_folder(frame_folder(folder, frame));  // claims lie there too
        names.push_back((std::filesystem::path(frame_folder("", frame)) / whole).string());
    }
    std::size_t made = 0;
    const bool done = with_progress(request.parts.quiet, [&](const RunControl& control) {
        const auto make = [&](std::size_t i) {
            const long frame = request.frames[i];
            return naming_frame(static_cast<double>(frame),
                                [&] { return film.make(frame, control); });
        };
        made = make_claimed_parts(
            {folder, names, std::chrono::milliseconds(std::lround(expiry_seconds * 1000)), make},
            control);
        return !*control.stop;
    });
    if (!request.parts.quiet)
        tell(fmt::format("{} of {} frames made here in {:.2f} s\n", made, names.size(),
                         clock.lap()));
    return done ? ExitCode::done : exit_code_of_stop(goes_on);
}

ExitCode render_film_keeping(const FilmRequest& request, const std::string& folder,
                             const FilmPath& out) {
    FilmJoin join{folder, out, request.parts.stats, request.parts.quiet};
    Film film(request, folder);
    require_film_output(join, request.frames, shape_of(film.scene()), request.parts.channels);
    const bool done = with_progress(request.parts.quiet, [&](const RunControl& control) {
        return for_frames(request.frames, control, [&](long frame, const RunControl& share) {
            return film.keep(frame, share);
        });
    });
    if (!done) {
        if (!request.parts.quiet) tell("stopped; the same command goes on from here\n");
        return exit_code_of_stop(goes_on);
    }
    join.frames = request.frames;
    return join_film(join);
}

}  // namespace pxm::host
