// The manual's pages in the form that scdoc turns into pages for man: what the program says of
// itself, around a text of docs/man/.
#pragma once

#include <string>
#include <vector>

#include "host/commands/command_facts.hpp"

namespace pxm::host {

/// The page of a command, or of the program if it is `commands.front()`. `text` is what stands
/// below DESCRIPTION, further sections with it.
[[nodiscard]] std::string command_page(const CommandFacts& command,
                                       const std::vector<CommandFacts>& commands,
                                       const std::string& text);

/// The page of the scene language: all of its text is in docs/man/.
[[nodiscard]] std::string scene_page(const std::string& text);

}  // namespace pxm::host
