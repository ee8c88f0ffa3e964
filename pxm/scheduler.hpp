// Host threads for the nodes: each takes a whole node, then the next one that nobody has taken.
#pragma once

#include <functional>

namespace pxm {

/// Calls work(0) ... work(count - 1), each once, on at most `threads` host threads (at least one;
/// fewer where the system starts no more). If `work` throws, no further node is begun and the first
/// exception is thrown here.
void for_each_node(int count, int threads, const std::function<void(int)>& work);

}  // namespace pxm
