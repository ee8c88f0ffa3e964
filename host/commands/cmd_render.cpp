// `pxm render SCENE [-o OUT]`: a picture, or with --pixel one ray's descent.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>

#include "host/commands/cmd.hpp"
#include "host/commands/exr_options.hpp"
#include "host/commands/film_stream.hpp"
#include "host/commands/option_checks.hpp"
#include "host/commands/picture_file.hpp"
#include "host/commands/picture_options.hpp"
#include "host/commands/render_arguments.hpp"
#include "host/commands/render_film_parts.hpp"
#include "host/commands/render_frames.hpp"
#include "host/commands/render_parts.hpp"
#include "host/commands/scene_options.hpp"
#include "host/commands/shared_options.hpp"
#include "host/files/safe_file.hpp"
#include "host/inspect/exact_facts.hpp"
#include "host/inspect/neighbour_channel.hpp"
#include "host/output/cost_model_json.hpp"
#include "host/output/image.hpp"
#include "host/output/spared_inputs.hpp"
#include "host/output/statistics_json.hpp"
#include "host/process/granted_threads.hpp"
#include "host/process/interrupt.hpp"
#include "host/process/limits.hpp"
#include "host/process/progress.hpp"
#include "host/process/terminal.hpp"
#include "host/render/render.hpp"
#include "host/render/render_options.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace {

/// What the nodes run.
NodeCode parse_program(const std::string& text, const Model* machine) {
    if (text != "default" && text != "asm")
        throw Error(ErrorKind::setting,
                    "--program: expected default or asm, found " + printable(text));
    if (text == "default") return NodeCode::counted;
    if (machine == nullptr)
        throw Error(ErrorKind::setting,
                    "--program asm: only the machine's nodes run it (--machine MODEL)");
    return NodeCode::assembled;
}

bool shows_neighbours(const RenderArguments& a) {
    return !a.aov.empty() && a.machine.empty() &&
           std::ranges::count(parse_aovs(a.aov), Aov::neighbours) > 0;
}

RenderRequest request_of(const RenderArguments& a) {
    RenderRequest request;
    request.scene_path = a.scene;
    request.settings = parse_settings(a.set);
    request.allowed = a.allowed;
    request.overrides = overrides_of(a);
    if (!a.machine.empty()) request.machine = &parse_model("--machine", a.machine);
    if (!a.program.empty()) request.code = parse_program(a.program, request.machine);
    if (!a.cost_model.empty()) request.costs = read_cost_model(a.cost_model);
    const ThreadChoice choice = choose_threads(a.threads);
    request.threads = choice.threads;
    request.threads_because = choice.because;
    if (shows_neighbours(a))
        request.walks = [as_written = keep_numbers(request.settings)](
                            const Scene& scene, const CompiledScene& compiled) {
            return neighbour_walks(scene, as_written, compiled);
        };
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

ExitCode explain(const RenderArguments& arguments) {
    const auto [x, y] = parse_pixel(arguments.pixel);
    put_result(explain_pixel(request_of(arguments), x, y));
    return ExitCode::done;
}

/// What a run that makes parts is asked for.
PartsRequest parts_request_of(const RenderArguments& arguments) {
    PartsRequest parts;
    parts.channels = aovs_of(arguments);
    parts.render = request_of(arguments);
    parts.metadata = [&arguments, carrier = std::make_shared<SceneCarrier>(arguments)](
                         const RenderResult& result, double frame) {
        return metadata_of(arguments, result, *carrier, frame);
    };
    parts.stats = arguments.stats;
    parts.quiet = arguments.quiet;
    return parts;
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
    require_exr_options(arguments, aovs_of(arguments), out);
    request.outputs = outputs_of(arguments, out);
    RenderResult result;
    std::string partial;
    {
        Progress progress(arguments.quiet);
        RunControl control;
        control.stop = &stop_requested();
        if (progress.enabled()) control.progress = [&](double share) { progress.update(share); };
        SceneCarrier carrier(arguments);
        result =
            write_picture(arguments, request, out, control, Warnings::before, carrier, &partial);
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
    const bool frames_are_files = arguments.out.ends_with(".exr");
    if (!frames_are_files) require_exr_options(arguments, aovs_of(arguments), arguments.out);
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
        require_exr_options(arguments, aovs, out);
        (void)outputs_of(arguments, out);
    };
    SceneCarrier carrier(arguments);
    job.write_picture = [&](const RenderRequest& request, const std::string& out,
                            const RunControl& control) {
        return write_picture(arguments, request, out, control, Warnings::after, carrier);
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
    require_exr_options(arguments, aovs_of(arguments), arguments.out);
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

/// What is the counted kernels' alone.
void refuse_with_assembled(const RenderArguments& arguments) {
    if (!arguments.cost_model.empty())
        throw Error(ErrorKind::setting,
                    "--cost-model: with --program asm cycles are those of its instructions");
    if (!arguments.pixel.empty())
        throw Error(ErrorKind::setting,
                    "--pixel: a descent is told by the counted kernels, not by --program asm");
    const auto aovs = arguments.aov.empty() ? std::vector<Aov>{} : parse_aovs(arguments.aov);
    if (std::ranges::find(aovs, Aov::heap) != aovs.end())
        throw Error(ErrorKind::setting,
                    "--aov heap: the most cells in the heap are not known with --program asm");
}

ExitCode render_command(const RenderArguments& arguments) {
    if (!arguments.cost_model.empty() && arguments.machine.empty()) {
        throw Error(ErrorKind::setting,
                    "--cost-model: cycles are counted on the machine only (--machine MODEL)");
    }
    if (arguments.program == "asm") refuse_with_assembled(arguments);
    if (!arguments.pixel.empty()) return explain(arguments);
    const bool in_parts =
        !arguments.claim.empty() || !arguments.part.empty() || !arguments.keep.empty();
    if (in_parts) return render_in_parts(arguments);
    if (!arguments.frames.empty() || !arguments.format.empty() || arguments.out == "-")
        return render_film(arguments);
    return render_picture(arguments);
}

/// What makes a picture in parts, or one that survives.
void add_part_options(CommandOptions& command, RenderArguments& arguments) {
    const Option part = command.add_option(
        "--part", arguments.part,
        "I/N: only this part, into a file of the folder OUT (pxm join); auto: which one a launcher "
        "says (docs/cluster.md)");
    const Option claim = command.add_option("--claim", arguments.claim,
                                            "Make parts in this folder, one after another, that "
                                            "nobody else makes, until all are there");
    command
        .add_option("--claim-expiry", arguments.claim_expiry,
                    "Seconds after which a silent worker counts as dead; default 60")
        .transform(number_within(0.1, 86400));
    command
        .add_option("--keep", arguments.keep,
                    "Put what is done into this folder now and then; run again, go on from there")
        .excludes(part)
        .excludes(claim);
}

}  // namespace

AddedCommand add_render_command(CommandLine& line) {
    const auto a = std::make_shared<RenderArguments>();
    CommandOptions command = line.add_command("render", "Render a scene to a picture");
    command.add_option("scene", a->scene, "The scene file (.pxm), or a picture that carries one")
        .required();
    command.add_option("-o,--out", a->out,
                       "The picture, by extension png, exr, tif, jpg, ...; "
                       "default: the scene's name + .png");
    const Option native = command.add_flag("--native", a->native, "On the cores at hand (default)");
    command
        .add_option("--machine", a->machine, "On a simulated Pixel Machine: 964dX, 964, 940, ...")
        .excludes(native);
    command.add_option("--program", a->program,
                       "What its nodes run: default, the counted kernels; or asm, the node program "
                       "in DSP32 code (docs/dsp32.md)");
    command.add_option("--cost-model", a->cost_model,
                       "Cycles of the machine's operations, a JSON file (docs/machine.md)");
    add_threads_option(command, a->threads);
    command.add_option("--stats", a->stats, "Write statistics to this JSON file");
    add_part_options(command, *a);
    add_limit_options(command, a->limits);
    add_set_option(command, a->set);
    add_scene_options(command, *a);
    command.add_option("--frames", a->frames,
                       "Frames of an animation: 0-599, 0-599:10, 3,7,20-30; to "
                       "-o frames/%04d.png, film.mp4, film.webm, film.gif, or - with --format");
    command.add_option("--format", a->format, "With -o -: y4m or ppm, frame after frame");
    command.add_option("--aov", a->aov,
                       "Extra EXR channels: Z,node,cycles,volumes,level,heap,"
                       "alpha,object,word,neighbours,N");
    command.add_option("--half", a->half, "Channels that an EXR keeps in 16 bits: color,Z,N,alpha");
    command.add_flag("--data-window", a->data_window,
                     "A crop in an EXR stands at its place in the whole image");
    command.add_option("--cryptomatte", a->cryptomatte,
                       "Ids in an EXR for compositing programs: object, map or both");
    command.add_option("--pixel", a->pixel, "x,y: print this pixel's descent instead");
    command.add_flag("--no-scene", a->no_scene, "The picture does not carry its scene");
    command.add_flag("--quiet", a->quiet, "No progress bar, no summary");
    add_allow_option(command, a->allowed);
    command.check_all(some_text());
    return {command, [a] {
                find_scene_by_name(a->scene, a->allowed);
                hold_options_of_picture(*a);
                const LimitWatch watch(a->limits.limits());
                return render_command(*a);
            }};
}

}  // namespace pxm::host
