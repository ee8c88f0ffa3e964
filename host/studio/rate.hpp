// How many requests a second are worth answering: a page asks for tens, an attack for thousands.
#pragma once

#include <chrono>
#include <mutex>

namespace pxm::host {

/// A bucket that fills steadily and holds so many. Any thread.
class Rate {
  public:
    using Clock = std::chrono::steady_clock;

    Rate(double a_second, double most, Clock::time_point now = Clock::now())
        : a_second_(a_second), most_(most), left_(most), last_(now) {}

    /// Takes one out, if there is one.
    [[nodiscard]] bool take(Clock::time_point now = Clock::now());

  private:
    std::mutex mutex_;
    double a_second_;
    double most_;
    double left_;
    Clock::time_point last_;
};

}  // namespace pxm::host
