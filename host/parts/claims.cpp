#include "host/parts/claims.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <optional>
#include <system_error>

#include "host/error.hpp"
#include "host/files/destination.hpp"
#include "host/files/regular_file.hpp"

namespace pxm::host {

namespace fs = std::filesystem;

namespace {

constexpr int beats = 6;  // within the time after which a claim is of the dead

/// Whose claim it is, for people who look into the folder.
std::string worker_name() {
    std::array<char, 256> host{};
    gethostname(host.data(), host.size() - 1);
    return fmt::format("{} {}", host.data(), getpid());
}

/// Writes the text in one go over what is there; the file is closed, so that others see it.
bool overwrite(const std::string& path, int flags, const std::string& text) {
    constexpr mode_t by_umask = 0666;
    const int descriptor = open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOFOLLOW | flags, by_umask);
    if (descriptor < 0) return false;
    const bool written = write(descriptor, text.data(), text.size()) >= 0;
    return close(descriptor) == 0 && written;
}

/// The number has as many digits at every beat, so that no old end stays behind a shorter text.
std::string claim_text(std::uint64_t beat) {
    return fmt::format("{:010} {}\n", beat, worker_name());
}

/// Creates a claim, unless it is there: then false.
bool try_to_create(const std::string& path) {
    if (overwrite(path, O_CREAT | O_EXCL, claim_text(0))) return true;
    if (errno == EEXIST) return false;
    cannot_write(path, strerror(errno));
}

std::optional<std::string> text_in(const std::string& path) {
    try {
        return read_file(path);
    } catch (const Error&) {
        return std::nullopt;
    }
}

}  // namespace

Claim::Claim(std::string path, std::chrono::milliseconds expiry)
    : path_(std::move(path)), guard_(path_), pause_(expiry / beats), thread_([this] { beat(); }) {}

Claim::~Claim() {
    {
        const std::lock_guard lock(mutex_);
        done_ = true;
    }
    ended_.notify_all();
    thread_.join();
    unlink(path_.c_str());
}

/// A beat that cannot be written is the next one's business: at worst the part is made twice.
void Claim::beat() {
    std::unique_lock lock(mutex_);
    for (std::uint64_t count = 1; !ended_.wait_for(lock, pause_, [&] { return done_; }); ++count)
        (void)overwrite(path_, 0, claim_text(count));
}

std::string Claims::path_of(const std::string& name, int generation) const {
    return (fs::path(folder_) / fmt::format("{}.claim-{}", name, generation)).string();
}

bool Claims::is_dead(const std::string& name, int generation) {
    const auto text = text_in(path_of(name, generation));
    if (!text) return false;  // it was given back just now
    Seen& seen = seen_[name];
    const auto now = std::chrono::steady_clock::now();
    if (seen.generation != generation || seen.text != *text) {
        seen = {generation, *text, now};
        return false;
    }
    return now - seen.since >= expiry_;
}

std::unique_ptr<Claim> Claims::take(const std::string& name) {
    std::error_code none;
    int generation = 0;
    // A generation is looked at only once the one before it is known to be dead.
    const auto seen = seen_.find(name);
    if (seen != seen_.end() && seen->second.generation > 0) generation = seen->second.generation;
    while (!try_to_create(path_of(name, generation))) {
        if (!fs::exists(path_of(name, generation + 1), none)) {
            if (!is_dead(name, generation)) return nullptr;
        }
        ++generation;
    }
    return std::make_unique<Claim>(path_of(name, generation), expiry_);
}

void Claims::forget(const std::string& name) {
    const auto seen = seen_.find(name);
    const int last = seen == seen_.end() ? 1 : seen->second.generation + 1;
    for (int generation = 0; generation <= last; ++generation)
        unlink(path_of(name, generation).c_str());
}

}  // namespace pxm::host
