// How many threads the system lets a render have. OpenMP's run-time library ends the process where
// it cannot start one that was asked for.
#pragma once

namespace pxm::host {

/// As many of `wanted` threads as OpenMP can run at the same time, the caller's among them: at
/// least
/// 1. They are started to see it, and OpenMP's after them.
[[nodiscard]] int threads_that_start(int wanted);

}  // namespace pxm::host
