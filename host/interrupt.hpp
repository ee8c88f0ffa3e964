// Ctrl-C and SIGTERM: a flag that the engines look at, and the exit code they end with.
#pragma once

#include <atomic>

#include "host/error.hpp"

namespace pxm::host {

/// Installs the handlers. A second signal ends the process at once.
void catch_signals();

/// Set once a signal came.
[[nodiscard]] const std::atomic<bool>& stop_requested();

/// 130 after SIGINT, 143 after SIGTERM.
[[nodiscard]] ExitCode signal_exit_code();

}  // namespace pxm::host
