// What threads make in any order and a file wants in one.
#pragma once

#include <map>
#include <mutex>
#include <utility>

namespace pxm::host {

/// Things that come in any order and go in that of their numbers, which are 0, 1, 2, ... Any thread
/// may add.
template <class Thing>
class InOrder {
  public:
    /// `take(thing)` is called for all whose turn has come, by one thread at a time. After it has
    /// thrown, it is not called again: what would be repeated or come next has no place any more.
    template <class Take>
    void add(long number, Thing thing, const Take& take) {
        const std::lock_guard lock(mutex_);
        if (broken_) return;
        waiting_.emplace(number, std::move(thing));
        while (!waiting_.empty() && waiting_.begin()->first == next_) {
            broken_ = true;  // for as long as `take` has not returned
            take(waiting_.begin()->second);
            broken_ = false;
            waiting_.erase(waiting_.begin());
            ++next_;
        }
    }

  private:
    std::mutex mutex_;
    long next_ = 0;
    bool broken_ = false;
    std::map<long, Thing> waiting_;
};

}  // namespace pxm::host
