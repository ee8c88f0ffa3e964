#include "host/engine/threads.hpp"

#include <omp.h>
#include <sys/mman.h>

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

namespace pxm::host {

namespace {

/// Address space that is kept free while threads are tried, so that there is room for what they and
/// OpenMP need besides their stacks: under a limit that just holds the stacks, OpenMP would start
/// some threads and then end the process.
class Reserve {
  public:
    explicit Reserve(int threads)
        : bytes_((std::size_t{64} + 2 * static_cast<std::size_t>(threads)) << 20U),
          place_(mmap(nullptr, bytes_, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1,
                      0)) {}
    Reserve(const Reserve&) = delete;
    Reserve& operator=(const Reserve&) = delete;
    ~Reserve() {
        if (is_there()) munmap(place_, bytes_);
    }
    [[nodiscard]] bool is_there() const { return place_ != MAP_FAILED; }

  private:
    std::size_t bytes_;
    void* place_;
};

/// Threads that wait for each other, so that all are there at once: how many of them start.
int start_at_once(int count) {
    const Reserve reserve(count);
    if (!reserve.is_there()) return 0;
    std::mutex mutex;
    std::condition_variable all_there;
    bool done = false;
    std::vector<std::jthread> threads;
    try {
        threads.reserve(static_cast<std::size_t>(count));
        for (int i = 0; i < count; ++i) {
            threads.emplace_back([&] {
                std::unique_lock lock(mutex);
                all_there.wait(lock, [&] { return done; });
            });
        }
    } catch (const std::system_error&) {
        // So many it is.
    } catch (const std::bad_alloc&) {
        // Here too.
    }
    {
        const std::lock_guard lock(mutex);
        done = true;
    }
    all_there.notify_all();
    return static_cast<int>(threads.size());
}

}  // namespace

// OpenMP keeps its threads for the next loop: only further ones are tried, and at once made its
// own, before anybody else takes them. Where not all start, half of them leave the other half's
// room to what the render needs.
// Each thread that renders has an OpenMP team of its own, so what is known is known of one thread.
int threads_that_start(int wanted) {
    thread_local int known = 1;
    thread_local bool is_limit = false;
    if (is_limit || wanted <= known) return std::clamp(wanted, 1, known);
    const int started = start_at_once(wanted - known);
    is_limit = started < wanted - known;
    known += is_limit ? started / 2 : started;
#pragma omp parallel num_threads(known)
    {
        // Nothing to do but to be there.
    }
    return known;
}

}  // namespace pxm::host
