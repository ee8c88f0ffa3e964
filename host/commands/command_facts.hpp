// What the program says of itself: its commands with their options, as they are stated to the
// command line. Completion and the manual are made of it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pxm::host {

struct OptionFacts {
    std::vector<std::string> names;  // `-o`, `--out`; of an argument its word
    bool is_argument = false;
    std::string
        value;  // what it takes, as `FILE`, `N` or `on|off` (option_values.hpp); of a flag empty
    std::string range;  // of a number, as `1 to 1024`
    std::string what;
    bool required = false;
    bool several = false;  // it may be given again
};

struct CommandFacts {
    std::string name;  // of the program itself empty
    std::string what;
    std::vector<OptionFacts> options;  // the arguments first
};

/// The command of that name, or nullptr.
[[nodiscard]] const CommandFacts* find_command(const std::vector<CommandFacts>& commands,
                                               std::string_view name);
/// The option that has that name, or nullptr.
[[nodiscard]] const OptionFacts* find_option(const CommandFacts& command, std::string_view name);

}  // namespace pxm::host
