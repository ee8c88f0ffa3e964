// The command line: from arguments to one command's work and an exit code.
#pragma once

#include "host/process/exit_code.hpp"

namespace pxm::host {

/// Runs the program. Throws Error for the user's mistakes, which main prints.
[[nodiscard]] ExitCode run_command_line(int argc, const char* const* argv);

}  // namespace pxm::host
