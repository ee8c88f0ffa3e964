#include "host/parts/keep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <mutex>

#include "host/error.hpp"
#include "host/text/digest.hpp"

namespace pxm::host {

namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;
using Batch = std::map<std::size_t, std::string>;  // payloads by unit

// What is lost at most, of each thread: a share of what was done so far, between these.
constexpr int share_of_time = 8;
constexpr std::chrono::milliseconds least_patience{50}, most_patience{10'000};
constexpr std::size_t most_waiting_bytes = std::size_t{64} << 20U;

/// The name says what is in the file: two runs that keep the same write the same file.
std::string kept_name(const Batch& batch) {
    std::string text;
    for (const auto& [unit, payload] : batch)
        text += fmt::format("{} {}\n", unit, digest_of(payload));
    return fmt::format("kept-{:016x}{}", digest_of(text), part_ending);
}

/// Units that are done and not in the folder yet.
class Waiting {
  public:
    Waiting(const std::string& folder, const PartHeading& heading)
        : folder_(folder), heading_(heading) {}

    /// Called from any thread; one of them writes when it is time.
    void add(std::size_t unit, std::string payload) {
        Batch due;
        {
            const std::lock_guard lock(mutex_);
            bytes_ += payload.size();
            batch_.emplace(unit, std::move(payload));
            const auto now = Clock::now();
            const auto patience = std::clamp<Clock::duration>((now - start_) / share_of_time,
                                                              least_patience, most_patience);
            if (now - last_ < patience && bytes_ < most_waiting_bytes) return;
            due.swap(batch_);
            bytes_ = 0;
            last_ = now;
        }
        write(due);
    }

    /// After the threads.
    void write_rest() { write(std::exchange(batch_, {})); }

    [[nodiscard]] const std::vector<std::string>& paths() const { return paths_; }

  private:
    void write(const Batch& batch) {
        if (batch.empty()) return;
        const std::lock_guard lock(writing_);
        const std::string path = (fs::path(folder_) / kept_name(batch)).string();
        PartWriter file(path, heading_);
        for (const auto& [unit, payload] : batch) file.add(unit, payload);
        file.finish();
        paths_.push_back(path);
    }

    std::string folder_;
    const PartHeading& heading_;
    std::mutex mutex_, writing_;
    Batch batch_;
    std::size_t bytes_ = 0;
    Clock::time_point start_ = Clock::now();
    Clock::time_point last_ = start_;
    std::vector<std::string> paths_;
};

/// Reads all of a part, so that nothing damaged is found when it is too late to render it again.
PartReader whole_part(const std::string& path) {
    PartReader part(path);
    const RegularFile file(path);
    for (const UnitEntry& entry : part.entries()) (void)read_payload(file, entry);
    return part;
}

}  // namespace

PartSet kept_parts(const std::string& folder, const PartHeading& heading, std::string& warnings) {
    PartSet parts(heading);
    for (const std::string& path : part_paths(folder)) {
        std::optional<PartReader> part;
        try {
            part = whole_part(path);
        } catch (const Error& error) {
            warnings += fmt::format("warning: {}: what it holds is rendered again\n", error.what());
        }
        if (part) parts.add(path, *part);
    }
    return parts;
}

bool render_missing(const UnitRender& render, const std::string& folder, PartSet& parts) {
    const std::vector<std::size_t> wanted = parts.missing();
    if (wanted.empty()) return true;
    Waiting waiting(folder, render.heading);
    const TakeUnit take = [&](const FinishedUnit& unit) {
        const AlarmSums alarms = mark_alarms(render.heading.alarms, unit.pixels);
        waiting.add(unit.index, payload_of(unit, alarms, render.heading.channels));
    };
    const UnitsRun run = render.started.loaded->run_units(
        render.heading.grid, {parts.units(), wanted, take}, render.control);
    render.started.result.statistics.seconds.render += run.render_seconds;
    waiting.write_rest();
    for (const std::string& path : waiting.paths()) parts.add(path);
    return !run.stopped;
}

}  // namespace pxm::host
