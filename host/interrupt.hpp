// Ctrl-C and SIGTERM: a flag that the engines look at, and the exit code they end with. Where
// nobody looks at it the process ends by itself, soon and without a partial file.
#pragma once

#include <atomic>
#include <string>

#include "host/error.hpp"

namespace pxm::host {

/// Installs the handlers. A signal sets stop_requested(); if the process is not over half a second
/// later, if a second signal comes, or if a file is being written, it ends at once, with
/// signal_exit_code() and without the file's beginnings.
void catch_signals();

/// Set once a signal came.
[[nodiscard]] const std::atomic<bool>& stop_requested();

/// 130 after SIGINT, 143 after SIGTERM.
[[nodiscard]] ExitCode signal_exit_code();

/// While it lives, a signal removes that file. One at a time; a path too long for the system's
/// calls is not guarded.
class PartFileGuard {
  public:
    explicit PartFileGuard(const std::string& path);
    ~PartFileGuard();
    PartFileGuard(const PartFileGuard&) = delete;
    PartFileGuard& operator=(const PartFileGuard&) = delete;
};

}  // namespace pxm::host
