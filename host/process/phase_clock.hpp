// Seconds of one phase after the other.
#pragma once

#include <chrono>

namespace pxm::host {

/// Seconds since the last call, for one phase after the other.
class PhaseClock {
  public:
    double lap() {
        const auto now = std::chrono::steady_clock::now();
        const double seconds = std::chrono::duration<double>(now - last_).count();
        last_ = now;
        return seconds;
    }

  private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace pxm::host
