// Work that can be given up before it has a result: what a scene is prepared with takes long for
// tens of thousands of maps, and who waits for it may want something else by then. Loops of such
// work ask now and then; who never says that anything may be given up notices nothing.
#pragma once

#include <atomic>

namespace pxm::host {

/// Thrown by work that was given up. It is no error: whoever asked for it knows.
struct GivenUp {};

/// While this stands, the work of this thread is given up once `stop` is set.
class MayGiveUp {
  public:
    explicit MayGiveUp(const std::atomic<bool>& stop) : before_(asked()) { asked() = &stop; }
    ~MayGiveUp() { asked() = before_; }
    MayGiveUp(const MayGiveUp&) = delete;
    MayGiveUp& operator=(const MayGiveUp&) = delete;

    /// What this thread looks at; null: nothing.
    static const std::atomic<bool>*& asked() {
        thread_local const std::atomic<bool>* stop = nullptr;
        return stop;
    }

  private:
    const std::atomic<bool>* before_;
};

/// To be called every few thousand operations. Throws GivenUp.
inline void give_up_if_asked() {
    const std::atomic<bool>* stop = MayGiveUp::asked();
    if (stop != nullptr && stop->load(std::memory_order_relaxed)) throw GivenUp{};
}

}  // namespace pxm::host
