#include "pxm/scheduler.hpp"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace pxm {

void for_each_node(int count, int threads, const std::function<void(int)>& work) {
    std::atomic<int> next = 0;
    const auto take_nodes = [&] {
        for (int node = next++; node < count; node = next++) work(node);
    };
    std::vector<std::jthread> helpers;
    for (int i = 1; i < std::min(threads, count); ++i) helpers.emplace_back(take_nodes);
    take_nodes();
}

}  // namespace pxm
