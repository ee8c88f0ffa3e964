#include "host/studio/presence.hpp"

#include <utility>

namespace pxm::host {

std::shared_ptr<void> Presence::enter(std::function<void()> left) {
    {
        const std::lock_guard lock(room_->mutex);
        ++room_->pages;
        room_->visited = true;
    }
    const std::weak_ptr<Room> room = room_;
    const auto leave = [room, left = std::move(left)](void*) {
        const auto shared = room.lock();
        if (!shared) return;
        {
            const std::lock_guard lock(shared->mutex);
            --shared->pages;
            shared->left = Clock::now();
        }
        left();
    };
    return {static_cast<void*>(room_.get()), leave};  // what is held is being there, not the room
}

double Presence::seconds_alone(Clock::time_point now) const {
    const std::lock_guard lock(room_->mutex);
    if (room_->pages > 0 || !room_->visited) return -1;
    return std::chrono::duration<double>(now - room_->left).count();
}

int Presence::pages() const {
    const std::lock_guard lock(room_->mutex);
    return room_->pages;
}

}  // namespace pxm::host
