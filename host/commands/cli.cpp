#include "host/commands/cli.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "host/commands/cmd.hpp"
#include "host/commands/completion.hpp"
#include "host/commands/version.hpp"
#include "host/process/terminal.hpp"

namespace pxm::host {

namespace {

/// The words of a line to complete, as scripts of shells ask for it.
std::optional<std::vector<std::string>> words_to_complete(int argc, const char* const* argv) {
    const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
    if (words.size() < 3 || words[0] != "completion" || words[1] != "words") return std::nullopt;
    return std::vector<std::string>(words.begin() + (words[2] == "--" ? 3 : 2), words.end());
}

/// `pxm --version --json`
bool asks_for_json(int argc, const char* const* argv) {
    return argc == 3 && std::string_view(argv[1]) == "--version" &&
           std::string_view(argv[2]) == "--json";
}

}  // namespace

std::vector<AddedCommand> add_commands(CommandLine& line) {
    std::vector<AddedCommand> commands{
        add_render_command(line),     add_join_command(line),    add_check_command(line),
        add_inspect_command(line),    add_points_command(line),  add_import_command(line),
        add_export_command(line),     add_compare_command(line), add_study_command(line),
        add_models_command(line),     add_asm_command(line),     add_studio_command(line),
        add_completion_command(line), add_manual_command(line)};
    line.name_values(value_names());
    return commands;
}

ExitCode run_command_line(int argc, const char* const* argv) {
    CommandLine line(
        "pxm", "Ray traces linear fractals, on a simulated Pixel Machine or on the cores at hand.",
        version_text());
    const std::vector<AddedCommand> commands = add_commands(line);
    if (asks_for_json(argc, argv)) {
        put_result(version_json());
        return ExitCode::done;
    }
    if (const auto words = words_to_complete(argc, argv)) {
        put_result(completions(line.facts(), *words));
        return ExitCode::done;
    }
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
