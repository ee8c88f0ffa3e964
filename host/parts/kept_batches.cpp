#include "host/parts/kept_batches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "host/parts/part_file.hpp"
#include "host/text/digest.hpp"

namespace pxm::host {

namespace {

// What is lost at most, of each thread: a share of what was done so far, between these.
constexpr int share_of_time = 8;
constexpr std::chrono::milliseconds least_patience{50}, most_patience{10'000};
constexpr std::size_t most_waiting_bytes = std::size_t{64} << 20U;

/// The name says what is in the file: two runs that keep the same write the same file.
std::string kept_name(const Payloads& batch) {
    std::string text;
    for (const auto& [unit, payload] : batch)
        text += fmt::format("{} {}\n", unit, digest_of(payload));
    return fmt::format("kept-{:016x}{}", digest_of(text), part_ending);
}

}  // namespace

void KeptBatches::add(std::size_t unit, std::string payload) {
    Payloads due;
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

void KeptBatches::write(const Payloads& batch) {
    if (batch.empty()) return;
    const std::lock_guard lock(writing_);
    const std::string path = (std::filesystem::path(folder_) / kept_name(batch)).string();
    PartWriter file(path, heading_);
    for (const auto& [unit, payload] : batch) file.add(unit, payload);
    file.finish();
    paths_.push_back(path);
}

}  // namespace pxm::host
