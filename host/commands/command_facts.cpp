#include "host/commands/command_facts.hpp"

#include <algorithm>

namespace pxm::host {

const CommandFacts* find_command(const std::vector<CommandFacts>& commands, std::string_view name) {
    const auto found = std::ranges::find(commands, name, &CommandFacts::name);
    return found == commands.end() ? nullptr : &*found;
}

const OptionFacts* find_option(const CommandFacts& command, std::string_view name) {
    const auto found = std::ranges::find_if(command.options, [&](const OptionFacts& option) {
        return !option.is_argument && std::ranges::find(option.names, name) != option.names.end();
    });
    return found == command.options.end() ? nullptr : &*found;
}

}  // namespace pxm::host
