// Who computes next. A page asks for the next picture before it has the last one: the newest of its
// requests wins, the one under way is stopped, and those between are never begun.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace pxm::host {

class Turns {
  public:
    static constexpr std::size_t most_views = 64;  // pages, and kinds of what each asks for

    /// `at_once`: how many compute at the same time, of all pages.
    explicit Turns(int at_once) : free_(at_once) {}

    /// What tells a turn to end, and since when it does.
    struct Stop {
        std::atomic<bool> asked = false;
        std::chrono::steady_clock::time_point since{};  // written before `asked`
        void ask();
    };

    /// A turn that is being taken; it ends with this.
    class Turn {
      public:
        Turn(Turns& turns, std::string view, std::shared_ptr<Stop> stop)
            : turns_(&turns), view_(std::move(view)), stop_(std::move(stop)) {}
        Turn(Turn&& other) noexcept;
        Turn& operator=(Turn&&) = delete;
        ~Turn();
        /// Set once there is something newer to do: for RunControl::stop.
        [[nodiscard]] std::atomic<bool>& stop() const { return stop_->asked; }
        /// Milliseconds since it was told to stop; 0 if it was not.
        [[nodiscard]] double stopping_milliseconds() const;

      private:
        Turns* turns_;
        std::string view_;
        std::shared_ptr<Stop> stop_;
    };

    /// Waits for the turn of request number `serial` of a view. Nothing if a later one has come, if
    /// there are too many views, or after close().
    [[nodiscard]] std::optional<Turn> take(const std::string& view, std::uint64_t serial);

    /// Stops what the views whose names begin so are doing, and forgets them.
    void leave(const std::string& views);
    /// Stops everything, for good.
    void close();

  private:
    struct View {
        std::uint64_t newest = 0;
        bool running = false;
        bool left = false;
        int waiting = 0;
        std::shared_ptr<Stop> stop = std::make_shared<Stop>();
    };
    View* view_called(const std::string& name);
    void end(const std::string& view);
    void forget_if_idle(const std::string& name);

    std::mutex mutex_;
    std::condition_variable changed_;
    std::map<std::string, View> views_;
    int free_;
    bool closed_ = false;
};

}  // namespace pxm::host
