// Wrong on purpose, in one of three ways: a trial of threads in which this program ends with 0 has
// seen nothing.
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <thread>

#include "pxm/scheduler.hpp"

namespace {

long sum = 0;

/// Threads of OpenMP, as the native and the wide engine have them.
void openmp() {
#pragma omp parallel for num_threads(4)
    for (int i = 0; i < 100'000; ++i) sum += i;
}

/// Threads of the standard library, as the machine has them.
void nodes() {
    pxm::for_each_node(64, 4, [](int node) {
        sum += node;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));  // so that others come, too
    });
}

/// A result that is announced by a variable which says nothing of what was written before it.
void announced() {
    static long result = 0;
    static std::atomic<bool> is_there = false;
    std::thread other([] {
        result = 1;
        is_there.store(true, std::memory_order_relaxed);
    });
    while (!is_there.load(std::memory_order_relaxed)) std::this_thread::yield();
    sum += result;
    other.join();
}

}  // namespace

int main(int count, char** arguments) {
    const char* kind = count == 2 ? arguments[1] : "";
    if (std::strcmp(kind, "openmp") == 0)
        openmp();
    else if (std::strcmp(kind, "nodes") == 0)
        nodes();
    else if (std::strcmp(kind, "announced") == 0)
        announced();
    else
        return 2;
    std::printf("%ld\n", sum);
    return 0;
}
