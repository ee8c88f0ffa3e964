#include "host/studio/turns.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace pxm::host {

Turns::Turn::Turn(Turn&& other) noexcept
    : turns_(std::exchange(other.turns_, nullptr)),
      view_(std::move(other.view_)),
      stop_(std::move(other.stop_)) {}

/// Only the first to ask counts.
void Turns::Stop::ask() {
    if (asked) return;
    since = std::chrono::steady_clock::now();
    asked = true;
}

double Turns::Turn::stopping_milliseconds() const {
    if (!stop_->asked) return 0;
    const auto passed = std::chrono::steady_clock::now() - stop_->since;
    return std::chrono::duration<double, std::milli>(passed).count();
}

Turns::Turn::~Turn() {
    if (turns_ != nullptr) turns_->end(view_);
}

Turns::View* Turns::view_called(const std::string& name) {
    const auto found = views_.find(name);
    if (found != views_.end()) return &found->second;
    if (views_.size() >= most_views) {
        const auto idle = std::ranges::find_if(views_, [](const auto& entry) {
            return !entry.second.running && entry.second.waiting == 0;
        });
        if (idle == views_.end()) return nullptr;
        views_.erase(idle);
    }
    return &views_[name];
}

std::optional<Turns::Turn> Turns::take(const std::string& name, std::uint64_t serial) {
    std::unique_lock lock(mutex_);
    if (closed_) return std::nullopt;
    View* view = view_called(name);
    if (view == nullptr || serial <= view->newest) return std::nullopt;
    view->newest = serial;
    view->left = false;
    view->stop->ask();
    changed_.notify_all();  // those that wait for a turn of this view give up
    ++view->waiting;
    changed_.wait(lock, [&] {
        return closed_ || view->left || view->newest != serial || (!view->running && free_ > 0);
    });
    --view->waiting;
    if (closed_ || view->left || view->newest != serial) {
        forget_if_idle(name);
        return std::nullopt;
    }
    view->running = true;
    --free_;
    view->stop = std::make_shared<Stop>();
    return Turn(*this, name, view->stop);
}

void Turns::end(const std::string& name) {
    const std::lock_guard lock(mutex_);
    views_.at(name).running = false;
    ++free_;
    forget_if_idle(name);
    changed_.notify_all();
}

/// Only those that were left: the newest number of others must not be forgotten.
void Turns::forget_if_idle(const std::string& name) {
    const auto found = views_.find(name);
    if (found == views_.end()) return;
    const View& view = found->second;
    if (view.left && !view.running && view.waiting == 0) views_.erase(found);
}

void Turns::leave(const std::string& views) {
    const std::lock_guard lock(mutex_);
    std::vector<std::string> names;
    for (auto& [name, view] : views_) {
        if (!name.starts_with(views)) continue;
        view.left = true;
        view.stop->ask();
        names.push_back(name);
    }
    for (const std::string& name : names) forget_if_idle(name);
    changed_.notify_all();
}

void Turns::close() {
    const std::lock_guard lock(mutex_);
    closed_ = true;
    for (auto& [name, view] : views_) view.stop->ask();
    changed_.notify_all();
}

}  // namespace pxm::host
