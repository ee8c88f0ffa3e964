// `pxm inspect SCENE`: what the scene is and what it will need, without rendering.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "host/commands/cmd.hpp"
#include "host/commands/option_checks.hpp"
#include "host/commands/picture_options.hpp"
#include "host/commands/shared_options.hpp"
#include "host/error.hpp"
#include "host/files/new_folder.hpp"
#include "host/files/safe_file.hpp"
#include "host/inspect/attractor_point.hpp"
#include "host/inspect/exact_facts.hpp"
#include "host/inspect/inspect_json.hpp"
#include "host/inspect/inspect_text.hpp"
#include "host/inspect/inspection.hpp"
#include "host/inspect/neighbour_files.hpp"
#include "host/inspect/render_needs.hpp"
#include "host/output/spared_inputs.hpp"
#include "host/process/granted_threads.hpp"
#include "host/process/interrupt.hpp"
#include "host/process/limits.hpp"
#include "host/process/terminal.hpp"
#include "host/scene/carried/carried_scene.hpp"
#include "host/scene/check/check.hpp"
#include "host/scene/check/settings.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace {

struct InspectArguments {
    std::string scene;
    std::vector<std::string> allowed;
    std::string out;
    std::vector<std::string> set;
    bool json = false;
    bool scene_alone = false;
    bool needs = false;
    int threads = 0;  // 0: those granted
    LimitArguments limits;
    std::vector<std::string> point;
    std::optional<long> neighbours;
};

constexpr std::uint64_t most_types = 1'000'000;

/// As far as the option says; steps grow with the types, of which each has many pairs of cells.
NeighbourLimits limits_of(const std::optional<long>& types) {
    NeighbourLimits limits;
    if (!types) return limits;
    constexpr std::size_t steps_a_type = 20'000;
    limits.types = static_cast<std::size_t>(*types);
    limits.steps = std::max(limits.steps, limits.types * steps_a_type);
    return limits;
}

void put(const std::string& text, const std::string& out) {
    if (out.empty()) {
        put_result(text);
    } else {
        write_text_safely(out, text);
    }
}

/// `--neighbours` makes a folder of the place that `-o` names.
bool writes_graphs(const InspectArguments& arguments) {
    return arguments.neighbours && !arguments.json && !arguments.out.empty();
}

void write_graphs(const Inspection& found, const std::string& folder) {
    const std::vector<NeighbourFile> files = neighbour_files(found);
    if (files.empty())
        throw Error(
            ErrorKind::scene,
            "no system of the scene has neighbours that were found finite: nothing to write");
    if (make_folders(folder))
        throw Error(ErrorKind::file,
                    fmt::format("cannot make the folder \"{}\"", printable_path(folder)));
    for (const NeighbourFile& file : files) {
        write_text_safely((std::filesystem::path(folder) / file.name).string(), file.text);
        put_result(file.name + "\n");
    }
}

ExitCode tell_needs(const InspectArguments& arguments) {
    RenderRequest request;
    request.scene_path = arguments.scene;
    request.settings = parse_settings(arguments.set);
    request.allowed = arguments.allowed;
    request.threads = choose_threads(arguments.threads).threads;
    if (!arguments.out.empty()) {
        require_writable(arguments.out);
        request.outputs = {arguments.out};
    }
    const auto needs = render_needs(request, stop_requested());
    if (!needs) return exit_code_of_stop("nothing is known yet");
    put(arguments.json ? render_needs_json(*needs) : render_needs_text(*needs), arguments.out);
    return ExitCode::done;
}

ExitCode inspect_scene(const InspectArguments& arguments) {
    const Settings settings = parse_settings(arguments.set);
    if (!arguments.out.empty() && !writes_graphs(arguments)) require_writable(arguments.out);
    Diagnostics diagnostics;
    const Scene scene = parse_scene(arguments.scene, settings, diagnostics, arguments.allowed);
    if (!diagnostics.has_errors()) check_scene(scene, diagnostics);
    diagnostics.throw_if_errors(scene.files);
    if (!arguments.out.empty()) require_spared({arguments.out}, inputs_of(scene));
    if (!arguments.point.empty()) {
        put(attractor_point(scene, arguments.point) + "\n", arguments.out);
        return ExitCode::done;
    }
    NeighbourLimits limits = limits_of(arguments.neighbours);
    limits.as_written = keep_numbers(settings);
    const Inspection found = inspect(scene, arguments.scene, diagnostics, limits);
    diagnostics.throw_if_errors(scene.files);
    const std::string warnings = diagnostics.warnings_text(scene.files);
    if (!warnings.empty()) tell(warnings + "\n");
    if (writes_graphs(arguments)) {
        write_graphs(found, arguments.out);
        return ExitCode::done;
    }
    put(arguments.json ? inspect_json(found) : inspect_text(found), arguments.out);
    return ExitCode::done;
}

/// The scene that a picture carries: its text as it is, and behind it what it includes.
ExitCode print_carried(const InspectArguments& arguments) {
    const std::string& path = arguments.scene;
    const auto carried = carried_scene_at(path);
    if (!carried)
        throw Error(ErrorKind::setting,
                    fmt::format("--scene: {} is no picture", printable_path(path)));
    std::string options, text;
    for (const auto& [name, value] : carried->options)
        options += " " + (name == "--set" ? text_of(parse_setting(value)) : name + " " + value);
    for (const SourceFile& file : carried->files) {
        if (!text.empty()) text += fmt::format("\n# --- {}\n", file.name);
        text += file.text;
    }
    if (!arguments.out.empty()) require_spared({arguments.out}, {{path, "the scene"}});
    tell(fmt::format("{}: {} of pxm {}, rendered with{}\n", printable_path(path),
                     carried->files.front().name, printable(carried->version),
                     options.empty() ? " no options" : options));
    for (const CarriedPicture& picture : carried->pictures)
        tell(fmt::format("{}: shows {}, which is not in it\n", printable_path(path), picture.name));
    put(text, arguments.out);
    return ExitCode::done;
}

}  // namespace

AddedCommand add_inspect_command(CommandLine& line) {
    const auto a = std::make_shared<InspectArguments>();
    CommandOptions command =
        line.add_command("inspect", "Say what a scene is and needs, without rendering");
    command.add_option("scene", a->scene, "The scene file (.pxm)").required().check(some_text());
    const Option json = command.add_flag("--json", a->json, "As JSON");
    command
        .add_flag("--scene", a->scene_alone,
                  "Print the scene that a picture carries; its options go to the standard error")
        .excludes(json);
    command
        .add_option("--point", a->point,
                    "Print the attractor's point whose address repeats these maps")
        .delimiter(',')
        .one_value();
    command
        .add_option("--neighbours", a->neighbours,
                    "Look for up to so many types of neighbours in exact numbers; default: 10000")
        .may_lack_value("10000")
        .transform(whole_number(1, most_types));
    command.add_flag("--needs", a->needs,
                     "Say how many seconds and bytes a native render will take, by a trial of some "
                     "of its pixels");
    add_threads_option(command, a->threads);
    add_limit_options(command, a->limits);
    add_set_option(command, a->set);
    command.add_option("-o,--out", a->out, "Write to this file; default: the standard output")
        .check(some_text());
    add_allow_option(command, a->allowed);
    return {command, [a] {
                find_scene_by_name(a->scene, a->allowed);
                if (a->scene_alone) return print_carried(*a);
                hold_settings_of_picture(a->scene, a->set);
                const LimitWatch watch(a->limits.limits());
                return a->needs ? tell_needs(*a) : inspect_scene(*a);
            }};
}

}  // namespace pxm::host
