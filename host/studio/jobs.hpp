// What is being computed, for the page that waits for it: how far a picture is, and what each node
// of the machine has done for it so far.
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "host/engine/node_watch.hpp"

namespace pxm::host {

/// One picture or study on its way.
struct Job {
    explicit Job(std::size_t nodes) : watch(nodes) {}

    std::atomic<double> share = 0;  // done, 0 to 1; 0 while the scene is prepared
    NodeWatch watch;
};

class Jobs {
  public:
    /// A job that is on the list until what is returned is let go. A view has one at a time: the
    /// newest.
    [[nodiscard]] std::shared_ptr<Job> begin(const std::string& view, std::size_t nodes = 0);
    /// Null if there is none.
    [[nodiscard]] std::shared_ptr<Job> find(const std::string& view);

  private:
    std::mutex mutex_;
    std::map<std::string, std::weak_ptr<Job>> jobs_;
};

}  // namespace pxm::host
