// The commands. Each adds its options to the command line and later does its work.
#pragma once

#include <functional>
#include <vector>

#include "host/commands/options.hpp"
#include "host/process/exit_code.hpp"

namespace pxm::host {

/// What a command does once the command line was read.
using CommandAction = std::function<ExitCode()>;

struct AddedCommand {
    CommandOptions command;
    CommandAction action;
};
/// Adds every command, in the order of the help, and says what their options take.
[[nodiscard]] std::vector<AddedCommand> add_commands(CommandLine& line);

/// `pxm render SCENE [-o OUT]`.
[[nodiscard]] AddedCommand add_render_command(CommandLine& line);
/// `pxm join DIR -o OUT`.
[[nodiscard]] AddedCommand add_join_command(CommandLine& line);
/// `pxm check SCENE... [--werror] [--format]`.
[[nodiscard]] AddedCommand add_check_command(CommandLine& line);
/// `pxm points SCENE -n N -o OUT.ply`.
[[nodiscard]] AddedCommand add_points_command(CommandLine& line);
/// `pxm inspect SCENE [--json] [-o FILE]`.
[[nodiscard]] AddedCommand add_inspect_command(CommandLine& line);
/// `pxm compare A B`.
[[nodiscard]] AddedCommand add_compare_command(CommandLine& line);
/// `pxm import FILE [-o SCENE]`.
[[nodiscard]] AddedCommand add_import_command(CommandLine& line);
/// `pxm export SCENE -o OUT`.
[[nodiscard]] AddedCommand add_export_command(CommandLine& line);
/// `pxm study KIND SCENE... -o DIR`.
[[nodiscard]] AddedCommand add_study_command(CommandLine& line);
/// `pxm studio [SCENE]`.
[[nodiscard]] AddedCommand add_studio_command(CommandLine& line);
/// `pxm models`.
[[nodiscard]] AddedCommand add_models_command(CommandLine& line);
/// `pxm asm FILE... [-o OBJECT]`.
[[nodiscard]] AddedCommand add_asm_command(CommandLine& line);
/// `pxm completion SHELL`.
[[nodiscard]] AddedCommand add_completion_command(CommandLine& line);
/// `pxm manual PAGE TEXT`, hidden. The line must outlive it.
[[nodiscard]] AddedCommand add_manual_command(CommandLine& line);

}  // namespace pxm::host
