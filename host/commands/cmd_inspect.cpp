// `pxm inspect SCENE`: what the scene is and what it will need, without rendering.
#include <cstdio>
#include <memory>

#include "host/commands/cmd.hpp"
#include "host/commands/option_checks.hpp"
#include "host/commands/shared_options.hpp"
#include "host/files/safe_file.hpp"
#include "host/inspect/attractor_point.hpp"
#include "host/inspect/inspect_json.hpp"
#include "host/inspect/inspect_text.hpp"
#include "host/inspect/inspection.hpp"
#include "host/inspect/render_needs.hpp"
#include "host/output/spared_inputs.hpp"
#include "host/process/granted_threads.hpp"
#include "host/process/interrupt.hpp"
#include "host/process/limits.hpp"
#include "host/process/terminal.hpp"
#include "host/scene/check/check.hpp"
#include "host/scene/check/settings.hpp"

namespace pxm::host {

namespace {

struct InspectArguments {
    std::string scene;
    std::vector<std::string> allowed;
    std::string out;
    std::vector<std::string> set;
    bool json = false;
    bool needs = false;
    int threads = 0;  // 0: those granted
    LimitArguments limits;
    std::vector<std::string> point;
};

void put(const std::string& text, const std::string& out) {
    if (out.empty()) {
        put_result(text);
    } else {
        write_text_safely(out, text);
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

}  // namespace

AddedCommand add_inspect_command(CommandLine& line) {
    const auto a = std::make_shared<InspectArguments>();
    CommandOptions command =
        line.add_command("inspect", "Say what a scene is and needs, without rendering");
    command.add_option("scene", a->scene, "The scene file (.pxm)").required().check(some_text());
    command.add_flag("--json", a->json, "As JSON");
    command
        .add_option("--point", a->point,
                    "Print the attractor's point whose address repeats these maps")
        .delimiter(',')
        .one_value();
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
                const LimitWatch watch(a->limits.limits());
                return a->needs ? tell_needs(*a) : inspect_scene(*a);
            }};
}

}  // namespace pxm::host
