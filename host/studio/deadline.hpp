// Until when work may go on: whoever works is told to stop then, whether or not it gets on. It
// lives beside the work, for a scene may keep one thread busy for hours without a word of progress.
#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace pxm::host {

class Deadline {
  public:
    /// Sets `stop`, which has to outlive this, after so many seconds.
    Deadline(std::atomic<bool>& stop, double seconds);

    /// Whether it was this that set it.
    [[nodiscard]] bool has_passed() const { return passed_; }

  private:
    std::mutex mutex_;
    std::condition_variable_any ended_;
    std::atomic<bool> passed_ = false;
    std::jthread watch_;  // last: it ends before what it looks at
};

}  // namespace pxm::host
