// Whether anybody looks at the studio: each page keeps a request open for as long as it is shown.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <mutex>

namespace pxm::host {

class Presence {
  public:
    using Clock = std::chrono::steady_clock;

    /// A page that is there until what is returned is let go; then `left` is called, if this still
    /// exists. Any thread.
    [[nodiscard]] std::shared_ptr<void> enter(std::function<void()> left);

    /// Seconds since the last page left; negative while one is there, or if none has come yet.
    [[nodiscard]] double seconds_alone(Clock::time_point now = Clock::now()) const;
    [[nodiscard]] int pages() const;

  private:
    struct Room {
        std::mutex mutex;
        int pages = 0;
        bool visited = false;
        Clock::time_point left;
    };
    std::shared_ptr<Room> room_ = std::make_shared<Room>();
};

}  // namespace pxm::host
