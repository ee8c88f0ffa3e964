#include "host/studio/jobs.hpp"

namespace pxm::host {

std::shared_ptr<Job> Jobs::begin(const std::string& view, std::size_t nodes) {
    const std::lock_guard lock(mutex_);
    std::erase_if(jobs_, [](const auto& entry) { return entry.second.expired(); });
    auto job = std::make_shared<Job>(nodes);
    jobs_[view] = job;
    return job;
}

std::shared_ptr<Job> Jobs::find(const std::string& view) {
    const std::lock_guard lock(mutex_);
    const auto found = jobs_.find(view);
    return found == jobs_.end() ? nullptr : found->second.lock();
}

}  // namespace pxm::host
