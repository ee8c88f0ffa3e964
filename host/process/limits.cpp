#include "host/process/limits.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <fstream>
#include <mutex>
#include <system_error>
#include <thread>

#include "host/error.hpp"
#include "host/process/control_group.hpp"
#include "host/process/interrupt.hpp"
#include "host/process/terminal.hpp"
#include "host/text/number_text.hpp"

namespace pxm::host {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds look_every{20};
constexpr std::chrono::seconds patience{5};  // "five seconds later" (docs/command-line.md)

std::atomic<bool> reached = false;
std::atomic<bool> taken_over = false;
std::string reached_text;  // no longer changed once `reached` is set

std::optional<std::uint64_t> whole_of_file(const fs::path& path) {
    const std::vector<std::string> words = first_words(path);
    return words.empty() ? std::nullopt : number_of_text<std::uint64_t>(words[0]);
}

std::optional<std::uint64_t> physical_bytes(const fs::path& root) {
    std::ifstream file(root / "proc/meminfo");
    std::string name;
    std::uint64_t kibibytes = 0;
    if (!(file >> name >> kibibytes) || name != "MemTotal:") return std::nullopt;
    return kibibytes * 1024;
}

}  // namespace

std::optional<MemoryGrant> granted_memory(const fs::path& root) {
    std::uint64_t least = physical_bytes(root).value_or(UINT64_MAX);
    std::string of_what = "the computer's memory";
    const auto look = [&](GroupVersion version, const char* file) {
        for (const fs::path& folder : group_folders(root, version, "memory")) {
            const auto limit = whole_of_file(folder / file);  // "max" where there is none
            if (!limit || *limit >= least) continue;
            least = *limit;
            of_what = "the control group's memory";
        }
    };
    look(GroupVersion::two, "memory.max");
    look(GroupVersion::one, "memory.limit_in_bytes");
    if (least == UINT64_MAX) return std::nullopt;
    return MemoryGrant{least / 4 * 3, "3/4 of " + of_what};
}

std::uint64_t memory_in_use() {
    // Nothing is allocated: there may be no memory left.
    const int descriptor = open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) return 0;
    char text[128];
    const ssize_t got = read(descriptor, text, sizeof text - 1);
    close(descriptor);
    if (got <= 0) return 0;
    text[got] = '\0';
    char* at = text;
    (void)std::strtoull(at, &at, 10);  // pages in all
    const std::uint64_t resident = std::strtoull(at, &at, 10);
    const std::uint64_t of_files = std::strtoull(at, &at, 10);
    return (resident - std::min(resident, of_files)) *
           static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

struct LimitWatch::State {
    std::optional<double> seconds;
    std::optional<MemoryGrant> memory;
    // Made beforehand: the thread allocates nothing.
    std::string seconds_text, memory_text;
    Clock::time_point start = Clock::now();
    std::mutex mutex;
    std::condition_variable over;
    bool is_over = false;
    std::thread thread;

    /// The limit's text; null as long as none is reached.
    [[nodiscard]] std::string* reason() {
        if (seconds && std::chrono::duration<double>(Clock::now() - start).count() > *seconds)
            return &seconds_text;
        if (memory && memory_in_use() > memory->bytes) return &memory_text;
        return nullptr;
    }

    /// False if the run is over first.
    bool sleep(std::unique_lock<std::mutex>& lock) {
        over.wait_for(lock, look_every, [&] { return is_over; });
        return !is_over;
    }

    void watch() {
        std::unique_lock lock(mutex);
        std::string* found = nullptr;
        while (!(found = reason()))
            if (!sleep(lock)) return;
        reached_text.swap(*found);
        reached = true;
        request_stop();
        const Clock::time_point end = Clock::now() + patience;
        while (!taken_over && received_signal() == 0) {
            const bool too_much = memory && memory_in_use() > memory->bytes / 4 * 5;
            if (too_much || Clock::now() > end) {
                tell("pxm: ");
                tell(reached_text);
                tell(": nothing was finished\n");
                end_at_once(static_cast<int>(ExitCode::parts_missing));
            }
            if (!sleep(lock)) return;
        }
    }
};

LimitWatch::LimitWatch(const Limits& limits) : state_(std::make_unique<State>()) {
    state_->seconds = limits.seconds;
    state_->memory = limits.memory_bytes ? MemoryGrant{*limits.memory_bytes, "--limit-memory"}
                                         : granted_memory();
    if (!state_->seconds && !state_->memory) return;
    if (state_->seconds)
        state_->seconds_text = fmt::format("the limit of {:g} s is reached", *limits.seconds);
    if (state_->memory)
        state_->memory_text = fmt::format("the limit of {} bytes of memory ({}) is reached",
                                          state_->memory->bytes, state_->memory->because);
    try {
        state_->thread = std::thread([state = state_.get()] { state->watch(); });
    } catch (const std::system_error&) {
        if (limits.seconds || limits.memory_bytes)
            throw Error(ErrorKind::failed,
                        "the system refuses the thread that watches over --limit-seconds and "
                        "--limit-memory");
    }
}

LimitWatch::~LimitWatch() {
    if (!state_->thread.joinable()) return;
    {
        const std::lock_guard lock(state_->mutex);
        state_->is_over = true;
    }
    state_->over.notify_all();
    state_->thread.join();
}

bool take_over_from_limit() {
    if (!reached || received_signal() != 0) return false;
    taken_over = true;
    return true;
}

ExitCode exit_code_of_stop(std::string_view outcome) {
    if (!take_over_from_limit()) return exit_code_of_signal(received_signal());
    tell(fmt::format("pxm: {}: {}\n", reached_text, outcome));
    return ExitCode::parts_missing;
}

}  // namespace pxm::host
