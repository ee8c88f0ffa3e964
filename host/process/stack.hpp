// Room for calls within calls, whatever the shell's limit (`ulimit -s`) is.
#pragma once

#include <functional>

namespace pxm::host {

/// Calls `work` with a stack of the usual 8 MB or more, on a thread of its own if need be, and
/// gives threads that are started later as much. `work` must not throw.
[[nodiscard]] int with_enough_stack(const std::function<int()>& work);

}  // namespace pxm::host
