// What a run may take, and what watches over it. A run that has reached a limit is asked to stop,
// as by a signal; whoever makes a file of what is done says so, else the process ends by itself
// soon.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "host/process/exit_code.hpp"

namespace pxm::host {

struct MemoryGrant {
    std::uint64_t bytes = 0;
    std::string because;  // a noun phrase: "3/4 of the computer's memory"
};

/// Three quarters of the smallest of the computer's memory and the limits of the process's control
/// group and those around it (cgroup v2 `memory.max`, v1 `memory.limit_in_bytes`); nothing if the
/// system says neither. `root` is the folder of `proc` and `sys`.
[[nodiscard]] std::optional<MemoryGrant> granted_memory(const std::filesystem::path& root = "/");

/// Bytes of memory that are the process's own, without what is mapped from files; 0 if the system
/// does not say.
[[nodiscard]] std::uint64_t memory_in_use();

/// What the command line says.
struct Limits {
    std::optional<double> seconds;
    std::optional<std::uint64_t> memory_bytes;  // nothing: granted_memory()
};

/// Watches while it lives; one at a time. Where the system refuses the thread that it needs, limits
/// that were asked for throw Error(ErrorKind::failed), and the default is not watched.
class LimitWatch {
  public:
    explicit LimitWatch(const Limits& limits);
    ~LimitWatch();
    LimitWatch(const LimitWatch&) = delete;
    LimitWatch& operator=(const LimitWatch&) = delete;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Whether a limit, and no signal, has stopped the run. Then the caller makes a file of what is
/// done: the process no longer ends by itself.
[[nodiscard]] bool take_over_from_limit();

/// Of a run that was stopped: that of the signal; or it tells which limit was reached and what
/// became of the work, a clause, and is that of a partial run.
[[nodiscard]] ExitCode exit_code_of_stop(std::string_view outcome);

}  // namespace pxm::host
