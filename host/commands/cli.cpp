#include "host/commands/cli.hpp"

#include <optional>
#include <string>

#include "host/commands/cmd.hpp"
#include "host/process/terminal.hpp"

namespace pxm::host {

namespace {

const char* version_text() {
    return "pxm " PXM_VERSION "\nrequired: " PXM_LIBRARIES;  // cmake/dependencies.cmake
}

}  // namespace

std::vector<AddedCommand> add_commands(CommandLine& line) {
    return {add_render_command(line),  add_join_command(line),   add_check_command(line),
            add_inspect_command(line), add_points_command(line), add_import_command(line),
            add_compare_command(line), add_study_command(line),  add_models_command(line),
            add_asm_command(line),     add_studio_command(line)};
}

ExitCode run_command_line(int argc, const char* const* argv) {
    CommandLine line(
        "pxm", "Ray traces linear fractals, on a simulated Pixel Machine or on the cores at hand.",
        version_text());
    const std::vector<AddedCommand> commands = add_commands(line);
    if (const std::optional<std::string> text = line.read(argc, argv)) {
        put_result(*text);
        return ExitCode::done;
    }
    for (const AddedCommand& added : commands) {
        if (added.command.given()) return added.action();
    }
    return ExitCode::command_line;
}

}  // namespace pxm::host
