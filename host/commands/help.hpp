// What stands around the options in the help and in the manual: examples, exit codes, and where to
// read on.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host/process/exit_code.hpp"

namespace pxm::host {

struct Example {
    std::string_view command;  // whose it is; of the program itself empty
    std::string_view line;
    std::string_view what;
};

/// Two of every command, and of the program.
[[nodiscard]] std::vector<Example> examples_of(std::string_view command);

struct ExitCodeMeaning {
    int code;
    std::string_view meaning;
};

/// All that the program ends with, in order.
[[nodiscard]] const std::vector<ExitCodeMeaning>& exit_code_meanings();

/// The help of a command, or of the program, given what the command line has to say.
[[nodiscard]] std::string help_text(std::string_view command, std::string options);

}  // namespace pxm::host
