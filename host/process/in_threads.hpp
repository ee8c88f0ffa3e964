// Steps that threads share, where OpenMP has no part: any order, each step once.
#pragma once

#include <atomic>
#include <cstddef>
#include <system_error>
#include <thread>
#include <vector>

#include "host/process/first_failure.hpp"

namespace pxm::host {

/// Calls work(i) for every i below `count` from at most so many threads, this one among them, until
/// `stop` is set or a step throws, which is thrown again. A thread that the system refuses is done
/// without. False if it was stopped.
template <class Work>
bool in_threads(int threads, std::size_t count, const std::atomic<bool>& stop, const Work& work) {
    std::atomic<std::size_t> next = 0;
    FirstFailure failure;
    const auto run = [&] {
        for (std::size_t i = next++; i < count && !stop; i = next++)
            failure.guard([&] { work(i); });
    };
    std::vector<std::jthread> others;
    try {
        while (static_cast<int>(others.size()) + 1 < threads) others.emplace_back(run);
    } catch (const std::system_error&) {
        // Those that there are do it.
    }
    run();
    others.clear();  // waits for them
    failure.rethrow();
    return !stop;
}

}  // namespace pxm::host
