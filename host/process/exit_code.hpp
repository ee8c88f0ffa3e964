// What the program ends with (docs/command-line.md).
#pragma once

#include "host/error.hpp"

namespace pxm::host {

enum class ExitCode : int {
    done = 0,
    run_failed = 1,
    command_line = 2,
    scene = 3,
    file = 4,
    machine_limit = 5,
    over_tolerance = 6,
    parts_missing = 7,  // also of a run that a limit ended
};

[[nodiscard]] constexpr ExitCode exit_code_of(ErrorKind kind) {
    switch (kind) {
        case ErrorKind::setting:
            return ExitCode::command_line;
        case ErrorKind::scene:
            return ExitCode::scene;
        case ErrorKind::file:
            return ExitCode::file;
        case ErrorKind::machine_limit:
            return ExitCode::machine_limit;
        case ErrorKind::failed:
            break;
    }
    return ExitCode::run_failed;
}

/// After a signal, as shells have it: 129 after SIGHUP, 130 after SIGINT, 143 after SIGTERM, 152
/// after SIGXCPU.
[[nodiscard]] constexpr ExitCode exit_code_of_signal(int signal) {
    return static_cast<ExitCode>(128 + signal);
}

}  // namespace pxm::host
