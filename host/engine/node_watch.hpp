// What the nodes of the simulated machine have done so far, for somebody who looks on while they
// work. Who starts a machine's render may lay out a watch for it, in the same thread.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pxm::host {

class NodeWatch {
  public:
    struct Seen {
        std::atomic<std::uint64_t> cycles = 0;
        std::atomic<std::uint32_t> pixels = 0;
    };

    explicit NodeWatch(std::size_t nodes) : nodes_(nodes) {}

    [[nodiscard]] const std::vector<Seen>& nodes() const { return nodes_; }
    /// By the thread that runs the node, after each of its pixels.
    void tell(std::size_t node, std::uint64_t cycles) {
        if (node >= nodes_.size()) return;
        nodes_[node].cycles.store(cycles, std::memory_order_relaxed);
        nodes_[node].pixels.fetch_add(1, std::memory_order_relaxed);
    }

    /// While this stands, machines that this thread starts are watched.
    class Laid {
      public:
        explicit Laid(NodeWatch* watch) : before_(laid()) { laid() = watch; }
        ~Laid() { laid() = before_; }
        Laid(const Laid&) = delete;
        Laid& operator=(const Laid&) = delete;

      private:
        NodeWatch* before_;
    };
    /// That of this thread; null: nobody looks on.
    static NodeWatch*& laid() {
        thread_local NodeWatch* watch = nullptr;
        return watch;
    }

  private:
    std::vector<Seen> nodes_;
};

}  // namespace pxm::host
