#include "host/parts/claim_run.hpp"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <thread>

#include "host/parts/claims.hpp"
#include "host/parts/part_file.hpp"

namespace pxm::host {

namespace {

constexpr std::chrono::milliseconds least_pause{20}, most_pause{1000};

bool is_stopped(const RunControl& control) { return control.stop != nullptr && *control.stop; }

/// Workers begin at different parts: so they seldom want the same.
std::vector<std::size_t> in_own_order(std::size_t parts) {
    std::vector<std::size_t> order;
    const auto begin = static_cast<std::size_t>(getpid());
    for (std::size_t i = 0; i < parts; ++i) order.push_back((i + begin) % parts);
    return order;
}

/// Waits for what others make, an eighth of the time that it has waited already: so a worker that
/// has nothing to do asks seldom, and ends soon after the last part is there.
class Patience {
  public:
    explicit Patience(std::chrono::milliseconds expiry)
        : most_(std::clamp(expiry / 10, least_pause, most_pause)) {}

    void wait(const RunControl& control) {
        const auto now = Clock::now();
        if (!waits_) since_ = now;
        waits_ = true;
        const auto end = now + std::clamp<Clock::duration>((now - since_) / 8, least_pause, most_);
        while (!is_stopped(control) && Clock::now() < end) std::this_thread::sleep_for(least_pause);
    }
    void renew() { waits_ = false; }

  private:
    using Clock = std::chrono::steady_clock;
    std::chrono::milliseconds most_;
    bool waits_ = false;
    Clock::time_point since_;
};

/// Makes the parts one by one.
class Worker {
  public:
    explicit Worker(const ClaimedParts& parts)
        : parts_(parts), claims_(parts.folder, parts.expiry) {}

    enum class State { there, made, others, stopped };

    State try_to_make(std::size_t part) {
        const std::string& name = parts_.names[part];
        const std::string path = (std::filesystem::path(parts_.folder) / name).string();
        if (is_there(path)) return claims_.forget(name), State::there;
        const std::unique_ptr<Claim> claim = claims_.take(name);
        if (!claim) return State::others;
        if (is_there(path)) return State::there;  // finished between the two looks
        if (!parts_.make(part)) return State::stopped;
        claims_.forget(name);
        return State::made;
    }

  private:
    static bool is_there(const std::string& path) {
        std::string why;  // what is damaged is made again
        return find_part(path, why).has_value();
    }

    const ClaimedParts& parts_;
    Claims claims_;
};

}  // namespace

long default_parts(std::size_t units) {
    constexpr std::size_t most = 256;
    return static_cast<long>(std::clamp<std::size_t>(units, 1, most));
}

std::size_t make_claimed_parts(const ClaimedParts& parts, const RunControl& control) {
    Worker worker(parts);
    std::vector<std::size_t> open = in_own_order(parts.names.size());
    Patience patience(parts.expiry);
    std::size_t made = 0;
    while (!open.empty() && !is_stopped(control)) {
        const std::size_t before = open.size();
        std::erase_if(open, [&](std::size_t part) {
            if (is_stopped(control)) return false;
            const Worker::State state = worker.try_to_make(part);
            if (state == Worker::State::made) ++made;
            return state == Worker::State::made || state == Worker::State::there;
        });
        if (open.size() == before) {
            patience.wait(control);
        } else {
            patience.renew();
        }
    }
    return made;
}

}  // namespace pxm::host
