// The progress bar with the time left: on a terminal only, never with NO_COLOR or --quiet.
#pragma once

#include <chrono>
#include <mutex>

namespace pxm::host {

/// Draws on stderr while it lives and wipes its line at the end. Calls may come from any thread.
class Progress {
  public:
    /// `quiet` keeps it silent, as does a stderr that is not a terminal.
    explicit Progress(bool quiet);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    [[nodiscard]] bool enabled() const { return enabled_; }
    /// Share done, 0..1; draws at most ten times a second.
    void update(double share);

  private:
    bool enabled_;
    std::mutex mutex_;
    std::chrono::steady_clock::time_point start_;
    std::chrono::steady_clock::time_point drawn_;
    double shown_ = 0;
};

}  // namespace pxm::host
