// How many threads the process may use: what the system grants it, not what the computer has.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace pxm::host {

inline constexpr int most_threads = 1024;

struct ThreadChoice {
    int threads = 1;
    std::string because;  // a clause: "the process may run on 1 of the computer's 2 cores"
};

/// The cores' worth of time that the process's control group and those around it may use (cgroup v2
/// `cpu.max`, v1 `cpu.cfs_quota_us`); empty if none has a limit or there are no groups. `root` is
/// the folder of `proc` and `sys`.
[[nodiscard]] std::optional<double> cpu_quota(const std::filesystem::path& root = "/");

/// The smallest of: the cores of the affinity mask; the quota, rounded up; OMP_NUM_THREADS and
/// OMP_THREAD_LIMIT of the environment. In 1..most_threads.
[[nodiscard]] ThreadChoice granted_threads(const std::filesystem::path& root = "/");

/// What --threads asked for; 0 stands for what is granted.
[[nodiscard]] ThreadChoice choose_threads(int asked);

}  // namespace pxm::host
