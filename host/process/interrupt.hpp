// Signals that end a run: a flag that the engines look at, and which one came. Where
// nobody looks at it the process ends by itself, soon and without a partial file.
#pragma once

#include <atomic>
#include <string>

namespace pxm::host {

/// Installs the handlers of SIGINT, SIGTERM, SIGHUP (unless it is ignored, as under nohup) and
/// SIGXCPU. A signal sets stop_requested(); if the process is not over half a second later, if a
/// second signal comes, or if a file is being written, it ends at once, with 128 and the
/// number of the signal, and
/// without the file's beginnings. SIGPIPE and SIGXFSZ are ignored: the write that caused them fails
/// and says so.
void catch_signals();

/// Set once a signal came, or a limit was reached (host/process/limits.hpp).
[[nodiscard]] const std::atomic<bool>& stop_requested();

/// The number of the signal that came; 0: none.
[[nodiscard]] int received_signal();

/// Sets stop_requested() as a signal does.
void request_stop();

/// Ends the process with that exit code, without the beginnings of files.
[[noreturn]] void end_at_once(int exit_code);

/// While it lives, a signal removes that file. So many at a time; one more, or one with a path too
/// long for the system's calls, is not guarded.
class PartFileGuard {
  public:
    static constexpr int most = 4;

    explicit PartFileGuard(const std::string& path);
    ~PartFileGuard();
    PartFileGuard(const PartFileGuard&) = delete;
    PartFileGuard& operator=(const PartFileGuard&) = delete;

  private:
    int slot_ = -1;
};

}  // namespace pxm::host
