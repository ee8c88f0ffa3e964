// The user's errors. Thrown anywhere in host/, caught in main only; the kind is the exit code.
#pragma once

#include <stdexcept>
#include <string>

namespace pxm::host {

/// What a run ends with (docs/command-line.md).
enum class ExitCode : int {
    done = 0,
    run_failed = 1,
    command_line = 2,
    scene = 3,
    file = 4,
    machine_limit = 5,
    over_tolerance = 6,
    interrupted = 130,
    terminated = 143,
};

/// A message for the user and the exit code it ends with. The text may have several lines.
class Error : public std::runtime_error {
  public:
    Error(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
    [[nodiscard]] ExitCode code() const noexcept { return code_; }

  private:
    ExitCode code_;
};

}  // namespace pxm::host
