// Exceptions of a parallel loop. One that leaves an OpenMP region, or an iteration of a loop that
// the threads share, ends the process: each step runs in here, the first exception is kept, and
// thrown again when the threads are done.
#pragma once

#include <atomic>
#include <exception>
#include <mutex>

namespace pxm::host {

class FirstFailure {
  public:
    /// Does a step, unless one has failed already. Any thread.
    template <class Step>
    void guard(const Step& step) noexcept {
        if (failed_.load(std::memory_order_relaxed)) return;
        try {
            step();
        } catch (...) {
            const std::lock_guard lock(mutex_);
            if (!failure_) failure_ = std::current_exception();
            failed_ = true;
        }
    }
    /// Throws what was kept, if anything. After the threads.
    void rethrow() const {
        if (failure_) std::rethrow_exception(failure_);
    }

  private:
    std::atomic<bool> failed_ = false;
    std::mutex mutex_;
    std::exception_ptr failure_;
};

}  // namespace pxm::host
