#include "host/commands/cli.hpp"

#include <CLI/CLI.hpp>
#include <sstream>

#include "host/commands/cmd.hpp"
#include "host/process/terminal.hpp"

namespace pxm::host {

namespace {

const char* version_text() {
    return "pxm " PXM_VERSION "\nrequired: " PXM_LIBRARIES;  // cmake/dependencies.cmake
}

/// CLI11 only says that a command is missing; a misspelt one is named here.
void require_known_command(const CLI::App& app, int argc, const char* const* argv) {
    const std::string word = argc > 1 ? argv[1] : "-";
    if (word.starts_with('-')) return;
    std::string known;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
        if (command->get_name() == word) return;
        known += " " + command->get_name();
    }
    throw Error(ErrorKind::setting, "unknown command \"" + word + "\", expected one of" + known);
}

}  // namespace

std::vector<AddedCommand> add_commands(CLI::App& app) {
    std::vector<AddedCommand> commands;
    for (const auto add :
         {add_render_command, add_check_command, add_inspect_command, add_points_command,
          add_import_command, add_compare_command, add_study_command, add_models_command}) {
        CommandAction action = add(app);
        commands.push_back({app.get_subcommands({}).back(), std::move(action)});
    }
    return commands;
}

ExitCode run_command_line(int argc, const char* const* argv) {
    CLI::App app(
        "Ray traces linear fractals, on a simulated Pixel Machine or on the cores at hand.", "pxm");
    app.set_version_flag("--version", version_text());
    app.require_subcommand(1);
    app.failure_message(CLI::FailureMessage::simple);
    const std::vector<AddedCommand> commands = add_commands(app);
    require_known_command(app, argc, argv);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& success) {
        std::ostringstream text, messages;  // --help, --version
        const auto code = static_cast<ExitCode>(app.exit(success, text, messages));
        put_result(text.str());
        return code;
    } catch (const CLI::ParseError& error) {
        throw Error(ErrorKind::setting,
                    std::string(error.what()) + "\ntry: pxm --help, or pxm COMMAND --help");
    }
    for (const AddedCommand& command : commands) {
        if (command.options->parsed()) return command.action();
    }
    return ExitCode::command_line;
}

}  // namespace pxm::host
