// What a run that survives puts aside: units that are done, in part files of their own, now and
// then.
#pragma once

#include <chrono>
#include <cstddef>
#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace pxm::host {

/// Units by their numbers, as the bytes of a part file.
using Payloads = std::map<std::size_t, std::string>;

/// Units that are done and not in the folder yet.
class KeptBatches {
  public:
    /// `heading` is what all part files say (host/parts/part_file.hpp).
    KeptBatches(std::string folder, std::string heading)
        : folder_(std::move(folder)), heading_(std::move(heading)) {}

    /// Called from any thread; one of them writes when it is time. Throws Error(ErrorKind::file).
    void add(std::size_t unit, std::string payload);
    /// After the threads.
    void write_rest() { write(std::exchange(batch_, {})); }

    /// The files that were written.
    [[nodiscard]] const std::vector<std::string>& paths() const { return paths_; }

  private:
    using Clock = std::chrono::steady_clock;

    void write(const Payloads& batch);

    std::string folder_;
    std::string heading_;
    std::mutex mutex_, writing_;
    Payloads batch_;
    std::size_t bytes_ = 0;
    Clock::time_point start_ = Clock::now();
    Clock::time_point last_ = start_;
    std::vector<std::string> paths_;
};

}  // namespace pxm::host
