#include "host/studio/rate.hpp"

#include <algorithm>

namespace pxm::host {

bool Rate::take(Clock::time_point now) {
    const std::lock_guard lock(mutex_);
    const double seconds = std::max(0.0, std::chrono::duration<double>(now - last_).count());
    last_ = std::max(last_, now);
    left_ = std::min(most_, left_ + seconds * a_second_);
    if (left_ < 1) return false;
    left_ -= 1;
    return true;
}

}  // namespace pxm::host
