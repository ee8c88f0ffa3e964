#include "pxm/scheduler.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace pxm {

void for_each_node(int count, int threads, const std::function<void(int)>& work) {
    std::atomic<int> next = 0;
    std::exception_ptr failure;
    std::mutex failing;
    const auto take_nodes = [&] {
        try {
            for (int node = next++; node < count; node = next++) work(node);
        } catch (...) {
            const std::lock_guard lock(failing);
            if (!failure) failure = std::current_exception();
            next = count;
        }
    };
    {
        std::vector<std::jthread> helpers;
        helpers.reserve(static_cast<std::size_t>(std::max(threads, 1)));
        try {
            for (int i = 1; i < std::min(threads, count); ++i) helpers.emplace_back(take_nodes);
        } catch (const std::system_error&) {
            // Those that run already take all nodes.
        }
        take_nodes();
    }
    if (failure) std::rethrow_exception(failure);
}

}  // namespace pxm
