// `pxm completion SHELL`: the script by which a shell completes pxm's command lines. The script
// asks with `pxm completion words -- WORDS`, which run_command_line answers: those words are no
// command.
#include <memory>

#include "host/commands/cmd.hpp"
#include "host/commands/completion.hpp"
#include "host/process/terminal.hpp"

namespace pxm::host {

AddedCommand add_completion_command(CommandLine& line) {
    const auto shell = std::make_shared<std::string>();
    CommandOptions command =
        line.add_command("completion", "Print what makes a shell complete pxm's command lines");
    command.add_option("shell", *shell, "Whose script to print").required();
    return {command, [shell] {
                put_result(completion_script(*shell));
                return ExitCode::done;
            }};
}

}  // namespace pxm::host
