// What may stand next on a command line: shells ask when Tab is pressed (docs/command-line.md).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host/commands/command_facts.hpp"

namespace pxm::host {

/// Lines of a word, a tab and what it is, for the last of `words`, which may be empty or begun. The
/// words are those after the program's name. A line `:files .pxm`, `:files` or `:folders` asks the
/// shell for names of files, too.
[[nodiscard]] std::string completions(const std::vector<CommandFacts>& commands,
                                      const std::vector<std::string>& words);

/// The script that tells a shell to ask: bash, zsh or fish. Throws Error(ErrorKind::setting) for
/// any other word.
[[nodiscard]] std::string completion_script(std::string_view shell);

}  // namespace pxm::host
