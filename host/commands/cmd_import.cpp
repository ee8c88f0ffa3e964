// `pxm import FILE [-o SCENE]`: what other programs made, an image or points as a scene.
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "host/commands/cmd.hpp"
#include "host/commands/option_checks.hpp"
#include "host/files/safe_file.hpp"
#include "host/import/import.hpp"
#include "host/import/moments/moment_search.hpp"
#include "host/output/spared_inputs.hpp"
#include "host/process/interrupt.hpp"
#include "host/process/terminal.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace {

struct ImportArguments {
    ImportRequest request;
    std::string entry;
    std::string out;
    bool force = false;
};

/// Throws Error unless the scene can be written there, and there is neither what it is made from
/// nor, where the user did not name the place, a file that he may need.
void require_scene_place(const ImportArguments& arguments, const std::string& out) {
    require_spared({out}, {{arguments.request.path, "what is imported"}});
    if (arguments.out.empty() && !arguments.force && std::filesystem::exists(out)) {
        throw Error(ErrorKind::setting,
                    fmt::format("{} is there already: --force replaces it, -o writes elsewhere",
                                printable_path(out)));
    }
    require_writable(out);
}

ExitCode import(const ImportArguments& arguments) {
    ImportRequest request = arguments.request;
    if (!arguments.entry.empty()) request.entry = arguments.entry;
    request.stop = [] { return stop_requested().load(); };
    const bool to_stdout = arguments.out == "-";
    if (!to_stdout && !arguments.out.empty()) require_scene_place(arguments, arguments.out);
    const Imported imported = import_file(request);
    if (stop_requested()) return exit_code_of_signal(received_signal());
    tell(imported.messages);
    if (to_stdout) {
        put_result(imported.text);
        return ExitCode::done;
    }
    const std::string out = arguments.out.empty() ? imported.name + ".pxm" : arguments.out;
    if (arguments.out.empty()) require_scene_place(arguments, out);
    write_text_safely(out, imported.text);
    const Scene& scene = imported.scene;
    tell(scene.ifs.empty()
             ? fmt::format("{}: {} objects\n", printable_path(out), scene.objects.size())
             : fmt::format("{}: {} maps\n", printable_path(out), scene.ifs[0].maps.size()));
    return ExitCode::done;
}

}  // namespace

AddedCommand add_import_command(CommandLine& line) {
    const auto a = std::make_shared<ImportArguments>();
    CommandOptions command = line.add_command(
        "import", "Turn another program's fractal, an image or a list of points into a scene");
    command
        .add_option(
            "file", a->request.path,
            "Of FRACTINT (.ifs, .l), flam3 (.flame), IFStile (.aifs), Structure Synth (.es) or "
            "IFSRenderer (.ifsjson); points (.xy, .txt); or an image")
        .required();
    command.add_option("-o,--out", a->out,
                       "The scene; - is the standard output; default: the entry's name + .pxm");
    command.add_flag("--force", a->force, "Replace a scene of the entry's name that is there");
    command.add_option("--entry", a->entry,
                       "The entry of a file that has several: its name, or #3");
    command.add_flag("--affine-part", a->request.affine_part,
                     "Of a flame: leave out the variations that are not linear");
    command.add_option("--maps", a->request.maps, "Maps to find for an image or points; default 4")
        .transform(whole_number(1, most_moment_maps));
    command
        .add_option("--seed", a->request.seed,
                    "Of the search for them, and of the rules of .es that are drawn; default 1")
        .transform(any_whole_number());
    command.add_option("--seconds", a->request.seconds, "Time for the search; default 20")
        .transform(number_within(0, 86400));
    return {command, [a] { return import(*a); }};
}

}  // namespace pxm::host
