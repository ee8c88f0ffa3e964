// `pxm manual PAGE TEXT`: a page of the manual for scdoc. The build runs it (cmake/manual.cmake);
// it is no command for users, and stands in no help.
#include <memory>

#include "host/commands/cmd.hpp"
#include "host/commands/manual.hpp"
#include "host/error.hpp"
#include "host/files/regular_file.hpp"
#include "host/process/terminal.hpp"

namespace pxm::host {

namespace {

struct ManualArguments {
    std::string page, text;
};

ExitCode print_page(const CommandLine& line, const ManualArguments& arguments) {
    const std::string text = read_file(arguments.text);
    if (arguments.page == "pxm-scene") {
        put_result(scene_page(text));
        return ExitCode::done;
    }
    const std::vector<CommandFacts> commands = line.facts();
    for (const CommandFacts& command : commands) {
        if (arguments.page != (command.name.empty() ? "pxm" : "pxm-" + command.name)) continue;
        put_result(command_page(command, commands, text));
        return ExitCode::done;
    }
    throw Error(ErrorKind::setting, "manual: there is no command of the page " + arguments.page);
}

}  // namespace

AddedCommand add_manual_command(CommandLine& line) {
    const auto a = std::make_shared<ManualArguments>();
    CommandOptions command = line.add_command("manual", "A page of the manual for scdoc");
    command.hide();
    command.add_option("page", a->page, "pxm, pxm-COMMAND or pxm-scene").required();
    command.add_option("text", a->text, "The file of docs/man/ with its text").required();
    return {command, [&line, a] { return print_page(line, *a); }};
}

}  // namespace pxm::host
