// `pxm join DIR -o OUT`: the picture of the parts in a folder.
#include <fmt/format.h>

#include <chrono>
#include <memory>

#include "host/commands/cmd.hpp"
#include "host/commands/join_film.hpp"
#include "host/commands/option_checks.hpp"
#include "host/error.hpp"
#include "host/files/safe_file.hpp"
#include "host/output/image.hpp"
#include "host/output/spared_inputs.hpp"
#include "host/output/statistics_json.hpp"
#include "host/parts/film_parts.hpp"
#include "host/parts/join.hpp"
#include "host/process/interrupt.hpp"
#include "host/process/progress.hpp"
#include "host/process/terminal.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace {

struct JoinArguments {
    std::string folder;
    std::string out;
    std::string stats;
    std::string format;
    bool quiet = false;
};

void require_outputs(const JoinArguments& arguments, const PartSet& parts) {
    std::vector<std::string> outputs{arguments.out};
    if (!arguments.stats.empty()) {
        require_spared({arguments.stats}, {{arguments.out, "the picture"}});
        outputs.push_back(arguments.stats);
    }
    std::vector<InputFile> inputs;
    for (const std::string& path : parts.paths()) inputs.push_back({path, "a part of it"});
    require_spared(outputs, inputs);
    for (const std::string& output : outputs) require_writable(output);
}

ExitCode run_join(const JoinArguments& arguments) {
    if (is_film_folder(arguments.folder))
        return join_film({arguments.folder,
                          {arguments.out, arguments.format},
                          arguments.stats,
                          arguments.quiet});
    if (!arguments.format.empty())
        throw Error(ErrorKind::setting, "--format: it is of the frames of a film (-o -)");
    const auto start = std::chrono::steady_clock::now();
    PartSet parts = read_parts(arguments.folder);
    require_image_format(arguments.out, parts.heading().channels);
    require_outputs(arguments, parts);
    std::optional<JoinedPicture> picture;
    {
        Progress progress(arguments.quiet);
        RunControl control;
        control.stop = &stop_requested();
        if (progress.enabled()) control.progress = [&](double share) { progress.update(share); };
        picture = join(parts, arguments.out, control);
    }
    if (!picture) return exit_code_of_signal(received_signal());
    tell(picture->warnings);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    Statistics& statistics = picture->statistics;
    statistics.seconds = {0, 0, 0, 0, took.count(), took.count()};
    statistics.threads = 1;
    statistics.threads_because = "parts were joined";
    if (!arguments.stats.empty()) write_text_safely(arguments.stats, statistics_json(statistics));
    if (!picture->missing.empty()) {
        tell(fmt::format("{}: {}\n", printable_path(arguments.folder), missing_text(parts)));
        return ExitCode::parts_missing;
    }
    const CropWindow& window = parts.heading().grid.window;
    if (!arguments.quiet) {
        tell(fmt::format("{}: {}x{} of {} parts in {:.2f} s\n", printable_path(arguments.out),
                         window.x1 - window.x0, window.y1 - window.y0, parts.paths().size(),
                         took.count()));
    }
    return ExitCode::done;
}

}  // namespace

AddedCommand add_join_command(CommandLine& line) {
    const auto a = std::make_shared<JoinArguments>();
    CommandOptions command = line.add_command("join", "Join the parts of a picture or a film");
    command.add_option("folder", a->folder, "The folder with the parts").required();
    command
        .add_option("-o,--out", a->out,
                    "The picture, by extension png, exr, tif, jpg, ...; of a film frames/%04d.png, "
                    "film.mp4, film.webm, film.gif, or - with --format")
        .required();
    command.add_option("--format", a->format, "With -o -: y4m or ppm, frame after frame");
    command.add_option("--stats", a->stats, "Write statistics to this JSON file");
    command.add_flag("--quiet", a->quiet, "No progress bar, no summary");
    command.check_all(some_text());
    return {command, [a] { return run_join(*a); }};
}

}  // namespace pxm::host
