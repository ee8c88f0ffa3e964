#include "host/studio/deadline.hpp"

#include <chrono>

namespace pxm::host {

Deadline::Deadline(std::atomic<bool>& stop, double seconds)
    : watch_([this, &stop, seconds](const std::stop_token& over) {
          std::unique_lock lock(mutex_);
          ended_.wait_for(lock, over, std::chrono::duration<double>(seconds), [] { return false; });
          // Work that somebody else has stopped is not late.
          if (over.stop_requested() || stop) return;
          passed_ = true;
          stop = true;
      }) {}

}  // namespace pxm::host
