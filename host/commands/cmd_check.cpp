// `pxm check SCENE...`: what is known of scenes without rendering them; or a scene formatted.
#include <algorithm>
#include <memory>

#include "host/commands/cmd.hpp"
#include "host/commands/option_checks.hpp"
#include "host/commands/picture_options.hpp"
#include "host/commands/shared_options.hpp"
#include "host/process/terminal.hpp"
#include "host/render/findings.hpp"
#include "host/scene/parse/parser.hpp"
#include "host/scene/print/format.hpp"

namespace pxm::host {

namespace {

struct CheckArguments {
    std::vector<std::string> scenes;
    std::vector<std::string> set;
    std::vector<std::string> allowed;
    bool werror = false;
    bool format = false;
};

/// Prints the findings; what a scene ends with.
ExitCode check_one(const std::string& scene, const CheckArguments& arguments) {
    Findings found;
    try {
        std::vector<std::string> set = arguments.set;
        hold_settings_of_picture(scene, set);
        found = findings_of(scene, parse_settings(set), arguments.allowed);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::file && error.kind() != ErrorKind::scene) throw;
        tell(std::string(error.what()) + "\n");
        return exit_code_of(error.kind());
    }
    if (!found.text.empty()) tell(found.text + "\n");
    return found.errors || (arguments.werror && found.warnings) ? ExitCode::scene : ExitCode::done;
}

/// Whether its text can be read as a scene: what is wrong beyond that has no bearing on its form.
void print_formatted(const std::string& scene, const std::vector<std::string>& allowed) {
    Diagnostics diagnostics;
    const Scene parsed = parse_scene(scene, diagnostics, allowed);
    if (!diagnostics.has_errors()) put_result(format_scene(parsed.files.front().text));
}

ExitCode check(const CheckArguments& arguments) {
    if (arguments.format && arguments.scenes.size() > 1)
        throw Error(ErrorKind::setting, "--format: it prints one scene, give it no more");
    (void)parse_settings(arguments.set);  // what is wrong with these is told before any scene
    ExitCode worst = ExitCode::done;
    for (const std::string& scene : arguments.scenes) {
        const ExitCode code = check_one(scene, arguments);
        worst = std::max(worst, code);
    }
    if (arguments.format && worst != ExitCode::file)
        print_formatted(arguments.scenes.front(), arguments.allowed);
    return worst;
}

}  // namespace

AddedCommand add_check_command(CommandLine& line) {
    const auto a = std::make_shared<CheckArguments>();
    CommandOptions command =
        line.add_command("check", "Say what is wrong with scenes, without rendering");
    command.add_option("scenes", a->scenes, "The scene files (.pxm)").required().check(some_text());
    add_set_option(command, a->set);
    add_allow_option(command, a->allowed);
    command.add_flag("--werror", a->werror, "Warnings count as errors");
    command.add_flag("--format", a->format,
                     "Print the scene formatted, with its comments, on the standard output");
    return {command, [a] {
                for (std::string& scene : a->scenes) find_scene_by_name(scene, a->allowed);
                return check(*a);
            }};
}

}  // namespace pxm::host
