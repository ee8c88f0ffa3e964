// The commands. Each adds its options to the command line and later does its work.
#pragma once

#include <functional>
#include <vector>

#include "host/process/exit_code.hpp"

namespace CLI {
class App;
}

namespace pxm::host {

/// What a command does once the command line was read.
using CommandAction = std::function<ExitCode()>;

struct AddedCommand {
    CLI::App* options;
    CommandAction action;
};
/// Adds every command, in the order of the help.
[[nodiscard]] std::vector<AddedCommand> add_commands(CLI::App& app);

/// `pxm render SCENE [-o OUT]`.
[[nodiscard]] CommandAction add_render_command(CLI::App& app);
/// `pxm check SCENE... [--werror] [--format]`.
[[nodiscard]] CommandAction add_check_command(CLI::App& app);
/// `pxm points SCENE -n N -o OUT.ply`.
[[nodiscard]] CommandAction add_points_command(CLI::App& app);
/// `pxm inspect SCENE [--json] [-o FILE]`.
[[nodiscard]] CommandAction add_inspect_command(CLI::App& app);
/// `pxm compare A B`.
[[nodiscard]] CommandAction add_compare_command(CLI::App& app);
/// `pxm import FILE [-o SCENE]`.
[[nodiscard]] CommandAction add_import_command(CLI::App& app);
/// `pxm study KIND SCENE... -o DIR`.
[[nodiscard]] CommandAction add_study_command(CLI::App& app);
/// `pxm models`.
[[nodiscard]] CommandAction add_models_command(CLI::App& app);

}  // namespace pxm::host
