#include "host/parts/claim_run.hpp"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <thread>

#include "host/parts/claims.hpp"

namespace pxm::host {

namespace {

constexpr std::chrono::milliseconds least_pause{20}, most_pause{1000};

bool is_stopped(const RunControl& control) { return control.stop != nullptr && *control.stop; }

/// Parts that have units. Workers begin at different ones: so they seldom want the same.
std::vector<long> open_parts(std::size_t units, long parts) {
    const long used = std::min(parts, static_cast<long>(units));
    std::vector<long> open;
    for (long i = 0; i < used; ++i) open.push_back((i + getpid()) % used + 1);
    return open;
}

void wait(const ClaimedParts& claimed, const RunControl& control) {
    const auto pause = std::clamp(claimed.expiry / 10, least_pause, most_pause);
    const auto end = std::chrono::steady_clock::now() + pause;
    while (!is_stopped(control) && std::chrono::steady_clock::now() < end)
        std::this_thread::sleep_for(least_pause);
}

/// Makes the parts one by one.
class Worker {
  public:
    Worker(const UnitRender& render, const ClaimedParts& claimed)
        : render_(render),
          claimed_(claimed),
          heading_(render.heading),
          units_(units_of(render.heading.grid).size()),
          claims_(claimed.folder, claimed.expiry) {
        heading_.parts = claimed.parts;
    }

    enum class State { there, made, others, stopped };

    State try_to_make(long part) {
        const std::string name = part_name(part, claimed_.parts);
        const std::string path = (std::filesystem::path(claimed_.folder) / name).string();
        if (is_there(path)) return claims_.forget(name), State::there;
        const std::unique_ptr<Claim> claim = claims_.take(name);
        if (!claim) return State::others;
        if (is_there(path)) return State::there;  // finished between the two looks
        heading_.part = part;
        const auto wanted = units_of_part(units_, part, claimed_.parts);
        if (!write_part({render_.started, heading_, render_.control}, wanted, path))
            return State::stopped;
        claims_.forget(name);
        return State::made;
    }

  private:
    static bool is_there(const std::string& path) {
        std::string why;  // what is damaged is made again
        return find_part(path, why).has_value();
    }

    const UnitRender& render_;
    const ClaimedParts& claimed_;
    PartHeading heading_;
    std::size_t units_;
    Claims claims_;
};

}  // namespace

long default_parts(std::size_t units) {
    constexpr std::size_t most = 256;
    return static_cast<long>(std::clamp<std::size_t>(units, 1, most));
}

bool make_claimed_parts(const UnitRender& render, const ClaimedParts& claimed,
                        const std::function<void(const std::string&)>& made) {
    Worker worker(render, claimed);
    std::vector<long> open = open_parts(units_of(render.heading.grid).size(), claimed.parts);
    while (!open.empty()) {
        bool moved = false;
        for (long& part : open) {
            if (is_stopped(render.control)) return false;
            const Worker::State state = worker.try_to_make(part);
            if (state == Worker::State::stopped) return false;
            if (state == Worker::State::others) continue;
            if (state == Worker::State::made) made(part_name(part, claimed.parts));
            part = 0;  // done
            moved = true;
        }
        std::erase(open, 0);
        if (!moved && !open.empty()) wait(claimed, render.control);
    }
    return true;
}

}  // namespace pxm::host
