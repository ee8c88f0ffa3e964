// `pxm inspect SCENE`: what the scene is and what it will need, without rendering.
#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "host/commands/cmd.hpp"
#include "host/commands/option_checks.hpp"
#include "host/commands/picture_options.hpp"
#include "host/commands/shared_options.hpp"
#include "host/files/safe_file.hpp"
#include "host/inspect/attractor_point.hpp"
#include "host/inspect/inspect_json.hpp"
#include "host/inspect/inspect_text.hpp"
#include "host/inspect/inspection.hpp"
#include "host/output/spared_inputs.hpp"
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
    std::vector<std::string> point;
};

void put(const std::string& text, const std::string& out) {
    if (out.empty()) {
        put_result(text);
    } else {
        write_text_safely(out, text);
    }
}

ExitCode inspect_scene(const InspectArguments& arguments) {
    const Settings settings = parse_settings(arguments.set);
    if (!arguments.out.empty()) require_writable(arguments.out);
    Diagnostics diagnostics;
    const Scene scene = parse_scene(arguments.scene, settings, diagnostics, arguments.allowed);
    if (!diagnostics.has_errors()) check_scene(scene, diagnostics);
    diagnostics.throw_if_errors(scene.files);
    if (!arguments.out.empty()) require_spared({arguments.out}, inputs_of(scene));
    if (!arguments.point.empty()) {
        put(attractor_point(scene, arguments.point) + "\n", arguments.out);
        return ExitCode::done;
    }
    const Inspection found = inspect(scene, arguments.scene, diagnostics);
    diagnostics.throw_if_errors(scene.files);
    const std::string warnings = diagnostics.warnings_text(scene.files);
    if (!warnings.empty()) tell(warnings + "\n");
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
    add_set_option(command, a->set);
    command.add_option("-o,--out", a->out, "Write to this file; default: the standard output")
        .check(some_text());
    add_allow_option(command, a->allowed);
    return {command, [a] {
                find_scene_by_name(a->scene, a->allowed);
                if (a->scene_alone) return print_carried(*a);
                hold_settings_of_picture(a->scene, a->set);
                return inspect_scene(*a);
            }};
}

}  // namespace pxm::host
