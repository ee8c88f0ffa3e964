// `pxm render SCENE [-o OUT]`: a picture, or with --pixel one ray's descent.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "host/commands/cmd.hpp"
#include "host/commands/film_stream.hpp"
#include "host/commands/option_checks.hpp"
#include "host/commands/render_film_parts.hpp"
#include "host/commands/render_frames.hpp"
#include "host/commands/render_parts.hpp"
#include "host/commands/shared_options.hpp"
#include "host/files/safe_file.hpp"
#include "host/output/cost_model_json.hpp"
#include "host/output/image.hpp"
#include "host/output/spared_inputs.hpp"
#include "host/output/statistics_json.hpp"
#include "host/output/taken_windows.hpp"
#include "host/process/granted_threads.hpp"
#include "host/process/interrupt.hpp"
#include "host/process/limits.hpp"
#include "host/process/phase_clock.hpp"
#include "host/process/progress.hpp"
#include "host/process/terminal.hpp"
#include "host/render/render.hpp"
#include "host/render/render_options.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace {

/// The options as they were written; empty where they were not.
struct RenderArguments {
    std::string scene;
    std::vector<std::string> allowed;
    std::string out;
    std::string machine;
    bool native = false;
    std::string cost_model;
    int threads = 0;  // 0: those granted
    std::string stats;
    std::string part, keep, claim;
    double claim_expiry = 60;  // seconds
    std::vector<std::string> set;
    std::string size, crop, numeric, covers, shading, intersect, lipschitz, volume, aov, pixel;
    std::optional<long> levels;
    std::optional<long> samples;
    std::optional<long> heap;
    std::optional<double> detail;
    double zoom = 1;
    std::string frames, format;
    bool quiet = false;
    LimitArguments limits;
};

SceneOverrides overrides_of(const RenderArguments& a) {
    SceneOverrides overrides;
    if (!a.size.empty()) overrides.size = parse_size(a.size);
    if (!a.crop.empty()) overrides.crop = parse_crop(a.crop);
    overrides.levels = a.levels;
    overrides.zoom = a.zoom;
    overrides.samples = a.samples;
    overrides.detail = a.detail;
    overrides.heap = a.heap;
    if (!a.numeric.empty()) overrides.numeric = parse_numeric(a.numeric);
    if (!a.covers.empty()) overrides.covers = parse_covers(a.covers);
    if (!a.shading.empty()) overrides.shading = parse_shading(a.shading);
    if (!a.intersect.empty()) overrides.intersect = parse_intersect(a.intersect);
    if (!a.lipschitz.empty()) overrides.lipschitz = parse_lipschitz(a.lipschitz);
    if (!a.volume.empty()) overrides.volume = parse_volume(a.volume);
    return overrides;
}

RenderRequest request_of(const RenderArguments& a) {
    RenderRequest request;
    request.scene_path = a.scene;
    request.settings = parse_settings(a.set);
    request.allowed = a.allowed;
    request.overrides = overrides_of(a);
    if (!a.machine.empty()) request.machine = &parse_model("--machine", a.machine);
    if (!a.cost_model.empty()) request.costs = read_cost_model(a.cost_model);
    const ThreadChoice choice = choose_threads(a.threads);
    request.threads = choice.threads;
    request.threads_because = choice.because;
    return request;
}

std::string default_out(const std::string& scene) {
    return std::filesystem::path(scene).stem().string() + ".png";
}

/// What will be written. Throws unless the picture and the statistics are two files that can be
/// written, and neither is one that the command line names to be read.
std::vector<std::string> outputs_of(const RenderArguments& arguments, const std::string& out) {
    std::vector<std::string> outputs{out};
    if (!arguments.stats.empty()) {
        require_spared({arguments.stats}, {{out, "the picture"}});
        outputs.push_back(arguments.stats);
    }
    std::vector<InputFile> inputs{{arguments.scene, "the scene"}};
    if (!arguments.cost_model.empty()) inputs.push_back({arguments.cost_model, "the cost model"});
    require_spared(outputs, inputs);
    for (const std::string& output : outputs) require_writable(output);
    return outputs;
}

Metadata metadata_of(const Statistics& s, const RenderArguments& a, const RenderResult& result) {
    std::string options;
    const auto note = [&](const char* name, const std::string& value) {
        if (!value.empty())
            options += fmt::format("{}{} {}", options.empty() ? "" : " ", name, value);
    };
    const auto text = [](const auto& value) { return value ? fmt::format("{}", *value) : ""; };
    note("--size", a.size);
    note("--crop", a.crop);
    note("--levels", text(a.levels));
    note("--zoom", a.zoom == 1 ? "" : fmt::format("{}", a.zoom));
    note("--samples", text(a.samples));
    note("--covers", a.covers);
    note("--shading", a.shading);
    note("--intersect", a.intersect);
    note("--lipschitz", a.lipschitz);
    note("--volume", a.volume);
    note("--detail", text(a.detail));
    note("--heap", text(a.heap));
    const std::string settings = text_of(parse_settings(a.set));
    if (!settings.empty()) options += (options.empty() ? "" : " ") + settings;
    return {{"version", PXM_VERSION},
            {"scene", s.scene},
            {"engine", s.engine},
            {"model", s.model},
            {"numeric", s.numeric},
            {"options", options},
            {"pixel_at_eye", fmt::format("{:.17g}", result.pixel_at_eye)},
            {"pixel_growth", fmt::format("{:.17g}", result.pixel_growth)}};
}

/// Whether what is known to be doubtful is told before the first ray, or by whoever collects it.
enum class Warnings { before, after };

/// The picture's file, from before the first ray on.
class PictureToFile : public PictureTaker {
  public:
    PictureToFile(const RenderArguments& arguments, const std::string& path,
                  const std::vector<Aov>& aovs, Warnings warnings)
        : arguments_(arguments), path_(path), aovs_(aovs), warnings_(warnings) {}

    void begin(const RenderResult& known) override {
        if (warnings_ == Warnings::before) tell(told_ = known.warnings);
        writer_.emplace(path_, known.window, aovs_,
                        metadata_of(known.statistics, arguments_, known));
    }
    void take(const Frame& part) override {
        writer_->append(part);
        taken_.add(part.crop);
    }
    void finish() { writer_->finish(); }
    /// Ends a picture that was given up: what was not taken is black. False if nothing was.
    bool finish_partial(const RenderResult& result) {
        if (!writer_ || taken_.pixels() == 0 || result.statistics.rays.pixels == 0) return false;
        taken_.fill(result.statistics.size, result.window,
                    [&](const Frame& black) { writer_->append(black); });
        writer_->finish();
        return true;
    }
    [[nodiscard]] long taken_pixels() const { return taken_.pixels(); }
    /// Leaves what was not told yet.
    void take_told(std::string& warnings) const {
        if (warnings.starts_with(told_)) warnings.erase(0, told_.size());
    }

  private:
    const RenderArguments& arguments_;
    const std::string& path_;
    const std::vector<Aov>& aovs_;
    Warnings warnings_;
    std::string told_;
    std::optional<ImageWriter> writer_;
    TakenWindows taken_;
};

ExitCode explain(const RenderArguments& arguments) {
    const auto [x, y] = parse_pixel(arguments.pixel);
    put_result(explain_pixel(request_of(arguments), x, y));
    return ExitCode::done;
}

/// The channels that were asked for.
std::vector<Aov> aovs_of(const RenderArguments& arguments) {
    const auto aovs = arguments.aov.empty() ? std::vector<Aov>{} : parse_aovs(arguments.aov);
    if (arguments.machine.empty() && std::ranges::find(aovs, Aov::cycles) != aovs.end()) {
        throw Error(ErrorKind::setting,
                    "--aov cycles: cycles are counted on the machine only (--machine MODEL)");
    }
    return aovs;
}

/// What a run that makes parts is asked for.
PartsRequest parts_request_of(const RenderArguments& arguments) {
    PartsRequest parts;
    parts.channels = aovs_of(arguments);
    parts.render = request_of(arguments);
    parts.metadata = [&arguments](const RenderResult& result) {
        return metadata_of(result.statistics, arguments, result);
    };
    parts.stats = arguments.stats;
    parts.quiet = arguments.quiet;
    return parts;
}

std::string partial_text(const std::string& out, const RenderResult& result, long taken) {
    const CropWindow& window = result.window;
    const long all = (window.x1 - window.x0) * (window.y1 - window.y0);
    const long known = std::min(taken, static_cast<long>(result.statistics.rays.pixels));
    return fmt::format("{} of {} pixels of {} are black", all - known, all, printable_path(out));
}

/// Renders one picture into its file. Nothing is written of one that was stopped, unless a limit
/// did so and there is a `partial`, which then says what is missing.
RenderResult write_picture(const RenderArguments& arguments, const RenderRequest& request,
                           const std::string& out, const RunControl& control, Warnings warnings,
                           std::string* partial = nullptr) {
    PhaseClock clock;
    const std::vector<Aov> aovs = aovs_of(arguments);
    PictureToFile picture(arguments, out, aovs, warnings);
    RenderResult result = render(request, control, &picture);
    picture.take_told(result.warnings);
    if (result.stopped) {
        if (partial && take_over_from_limit() && picture.finish_partial(result))
            *partial = partial_text(out, result, picture.taken_pixels());
        return result;
    }
    PhaseClock write_clock;
    picture.finish();
    PhaseSeconds& phases = result.statistics.seconds;
    phases.write = write_clock.lap();
    phases.total = clock.lap();
    return result;
}

void tell_summary(const std::string& out, const RenderResult& result) {
    const PhaseSeconds& seconds = result.statistics.seconds;
    tell(fmt::format("{}: {}x{} in {:.2f} s ({:.2f} Mray/s)\n", printable_path(out),
                     result.window.x1 - result.window.x0, result.window.y1 - result.window.y0,
                     seconds.total,
                     static_cast<double>(result.statistics.rays.eye_rays) / seconds.render / 1e6));
}

ExitCode render_picture(const RenderArguments& arguments) {
    RenderRequest request = request_of(arguments);
    const std::string out = arguments.out.empty() ? default_out(arguments.scene) : arguments.out;
    require_image_format(out, aovs_of(arguments));
    request.outputs = outputs_of(arguments, out);
    RenderResult result;
    std::string partial;
    {
        Progress progress(arguments.quiet);
        RunControl control;
        control.stop = &stop_requested();
        if (progress.enabled()) control.progress = [&](double share) { progress.update(share); };
        result = write_picture(arguments, request, out, control, Warnings::before, &partial);
    }
    if (result.stopped && partial.empty()) return exit_code_of_stop("no picture was written");
    tell(result.warnings);
    if (!arguments.stats.empty()) {
        write_text_safely(arguments.stats, statistics_json(result.statistics));
    }
    if (result.stopped) return exit_code_of_stop(partial);
    if (!arguments.quiet) tell_summary(out, result);
    return ExitCode::done;
}

/// What --frames, or frames on the standard output, make of it.
ExitCode render_film(const RenderArguments& arguments) {
    FilmJob job;
    job.request = request_of(arguments);
    job.frames = arguments.frames;
    job.out = arguments.out;
    job.format = arguments.format;
    job.stats = arguments.stats;
    job.quiet = arguments.quiet;
    const std::vector<Aov> aovs = aovs_of(arguments);
    job.require_picture = [&arguments, aovs](const std::string& out) {
        require_image_format(out, aovs);
        (void)outputs_of(arguments, out);
    };
    job.write_picture = [&](const RenderRequest& request, const std::string& out,
                            const RunControl& control) {
        return write_picture(arguments, request, out, control, Warnings::after);
    };
    return render_frames(job);
}

/// A film in parts, which has no other -o than its own.
ExitCode render_film_in_parts(const RenderArguments& arguments, const FilmRequest& film) {
    if (!arguments.claim.empty()) {
        if (!arguments.part.empty())
            throw Error(ErrorKind::setting, "--part: of a film each frame is a part (--claim)");
        return render_claimed_film(film, arguments.claim, arguments.claim_expiry);
    }
    if (!arguments.part.empty()) return render_part_of_film(film, arguments.part, arguments.out);
    return render_film_keeping(film, arguments.keep, {arguments.out, arguments.format});
}

ExitCode render_in_parts(const RenderArguments& arguments) {
    PartsRequest request = parts_request_of(arguments);
    if (!arguments.claim.empty() && !arguments.out.empty())
        throw Error(ErrorKind::setting, "-o: the parts are put into the folder of --claim");
    if (!arguments.frames.empty()) {
        const auto frames = frames_of_scene(arguments.frames, scene_of(request.render));
        if (frames.size() > 1)
            return render_film_in_parts(arguments, {request, arguments.frames, frames});
        request.render.frame = static_cast<double>(frames.front());
    }
    if (!arguments.claim.empty())
        return render_claimed(request, arguments.claim, arguments.part, arguments.claim_expiry);
    if (!arguments.part.empty()) return render_one_part(request, arguments.part, arguments.out);
    const std::string out = arguments.out.empty() ? default_out(arguments.scene) : arguments.out;
    request.render.outputs = outputs_of(arguments, out);
    return render_keeping(request, arguments.keep, out);
}

ExitCode render_command(const RenderArguments& arguments) {
    if (!arguments.cost_model.empty() && arguments.machine.empty()) {
        throw Error(ErrorKind::setting,
                    "--cost-model: cycles are counted on the machine only (--machine MODEL)");
    }
    if (!arguments.pixel.empty()) return explain(arguments);
    const bool in_parts =
        !arguments.claim.empty() || !arguments.part.empty() || !arguments.keep.empty();
    if (in_parts) return render_in_parts(arguments);
    if (!arguments.frames.empty() || !arguments.format.empty() || arguments.out == "-")
        return render_film(arguments);
    return render_picture(arguments);
}

}  // namespace

AddedCommand add_render_command(CommandLine& line) {
    const auto a = std::make_shared<RenderArguments>();
    CommandOptions command = line.add_command("render", "Render a scene to a picture");
    command.add_option("scene", a->scene, "The scene file (.pxm)").required();
    command.add_option("-o,--out", a->out,
                       "The picture, by extension png, exr, tif, jpg, ...; "
                       "default: the scene's name + .png");
    const Option native = command.add_flag("--native", a->native, "On the cores at hand (default)");
    command
        .add_option("--machine", a->machine, "On a simulated Pixel Machine: 964dX, 964, 940, ...")
        .excludes(native);
    command.add_option("--cost-model", a->cost_model,
                       "Cycles of the machine's operations, a JSON file (docs/machine.md)");
    add_threads_option(command, a->threads);
    command.add_option("--stats", a->stats, "Write statistics to this JSON file");
    const Option part = command.add_option(
        "--part", a->part,
        "I/N: only this part, into a file of the folder OUT (pxm join); auto: which one a launcher "
        "says (docs/cluster.md)");
    const Option claim = command.add_option("--claim", a->claim,
                                            "Make parts in this folder, one after another, that "
                                            "nobody else makes, until all are there");
    command
        .add_option("--claim-expiry", a->claim_expiry,
                    "Seconds after which a silent worker counts as dead; default 60")
        .transform(number_within(0.1, 86400));
    command
        .add_option("--keep", a->keep,
                    "Put what is done into this folder now and then; run again, go on from there")
        .excludes(part)
        .excludes(claim);
    add_limit_options(command, a->limits);
    add_set_option(command, a->set);
    command.add_option("--size", a->size, "WxH in pixels");
    command.add_option("--crop", a->crop, "x0,y0,x1,y1: only this window, half open");
    command.add_option("--levels", a->levels, "Stop after so many maps")
        .transform(whole_number(0, 1'000'000'000));
    command.add_option("--zoom", a->zoom, "Move the eye to look + (eye - look) / F")
        .transform(positive_number());
    command.add_option("--numeric", a->numeric, "dsp32, float or double");
    command.add_option("--samples", a->samples, "Samples a pixel")
        .transform(whole_number(1, 65536));
    command.add_option("--covers", a->covers, "on, off, area, or tmin,tmax in pixels");
    command.add_option("--shading", a->shading, "constant, low-pass, high-pass or facet");
    command.add_option("--intersect", a->intersect, "auto, heap, fast or wide");
    command.add_option("--lipschitz", a->lipschitz, "auto, product, determinant or polar");
    command.add_option("--volume", a->volume, "auto, sphere, box, oriented or hull");
    command.add_option("--detail", a->detail, "Cells are terminal at so many pixels")
        .transform(positive_number());
    command.add_option("--heap", a->heap, "Entries of the heap").transform(whole_number(1, 65536));
    command.add_option("--frames", a->frames,
                       "Frames of an animation: 0-599, 0-599:10, 3,7,20-30; to "
                       "-o frames/%04d.png, film.mp4, film.webm, film.gif, or - with --format");
    command.add_option("--format", a->format, "With -o -: y4m or ppm, frame after frame");
    command.add_option("--aov", a->aov,
                       "Extra EXR channels: Z,node,cycles,volumes,level,heap,"
                       "alpha,object,word,N");
    command.add_option("--pixel", a->pixel, "x,y: print this pixel's descent instead");
    command.add_flag("--quiet", a->quiet, "No progress bar, no summary");
    add_allow_option(command, a->allowed);
    command.check_all(some_text());
    return {command, [a] {
                find_scene_by_name(a->scene, a->allowed);
                const LimitWatch watch(a->limits.limits());
                return render_command(*a);
            }};
}

}  // namespace pxm::host
