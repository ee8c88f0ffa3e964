#include "host/files/checked_file.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "host/error.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace {

constexpr std::size_t collected_bytes = std::size_t{1} << 16;

/// Waits for a pipe that somebody made non-blocking.
void wait_until_it_takes(int descriptor) {
    pollfd one{descriptor, POLLOUT, 0};
    poll(&one, 1, -1);
}

/// What a system says of fsync() where there is nothing to do.
bool has_no_sync(int error) { return error == EINVAL || error == ENOSYS || error == ENOTSUP; }

}  // namespace

CheckedFile::CheckedFile(int descriptor, std::string name, Places places)
    : descriptor_(descriptor), name_(std::move(name)), places_(places) {
    try {
        collected_.reserve(collected_bytes);
    } catch (...) {
        close(descriptor_);
        throw;
    }
}

CheckedFile::~CheckedFile() { close(descriptor_); }

bool CheckedFile::put(std::int64_t place, const char* data, std::size_t bytes) noexcept {
    while (bytes > 0 && error_ == 0) {
        const ssize_t written = places_ == Places::any ? pwrite(descriptor_, data, bytes, place)
                                                       : write(descriptor_, data, bytes);
        if (written < 0) {
            if (errno == EAGAIN) {
                wait_until_it_takes(descriptor_);
            } else if (errno != EINTR) {
                error_ = errno;
            }
            continue;
        }
        if (written == 0) error_ = ENOSPC;  // it would be tried for ever
        data += written;
        place += written;
        bytes -= static_cast<std::size_t>(written);
    }
    return error_ == 0;
}

bool CheckedFile::flush() noexcept {
    put(collected_at_, collected_.data(), collected_.size());
    collected_at_ += static_cast<std::int64_t>(collected_.size());
    collected_.clear();
    return error_ == 0;
}

// The room for what is collected was reserved: nothing is allocated here.
bool CheckedFile::write_at(std::int64_t place, const void* data, std::size_t bytes) noexcept {
    const char* from = static_cast<const char*>(data);
    const bool follows = place == collected_at_ + static_cast<std::int64_t>(collected_.size());
    if (!follows || collected_.size() + bytes > collected_bytes) {
        if (!flush()) return false;
        collected_at_ = place;
    }
    if (bytes > collected_bytes) {
        collected_at_ = place + static_cast<std::int64_t>(bytes);
        return put(place, from, bytes);
    }
    collected_.insert(collected_.end(), from, from + bytes);
    return error_ == 0;
}

std::size_t CheckedFile::read_at(std::int64_t place, void* data, std::size_t bytes) noexcept {
    if (!flush()) return 0;
    std::size_t done = 0;
    while (done < bytes) {
        const ssize_t got = pread(descriptor_, static_cast<char*>(data) + done, bytes - done,
                                  place + static_cast<std::int64_t>(done));
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) break;
        done += static_cast<std::size_t>(got);
    }
    return done;
}

std::int64_t CheckedFile::size() noexcept {
    struct stat status {};
    if (!flush() || fstat(descriptor_, &status) != 0) return 0;
    return status.st_size;
}

void CheckedFile::append(const void* data, std::size_t bytes) {
    write_at(end_, data, bytes);
    end_ += static_cast<std::int64_t>(bytes);
    require();
}

void CheckedFile::require() const {
    if (error_ == 0) return;
    throw Error(ErrorKind::file,
                fmt::format("cannot write {}: {}", printable_path(name_), strerror(error_)));
}

// Network file systems tell at a close what became of writes. Closing a second descriptor of the
// same file asks them while the first still holds its lock.
void CheckedFile::sync() {
    flush();
    require();
    if (fsync(descriptor_) != 0 && !has_no_sync(errno)) error_ = errno;
    const int second = dup(descriptor_);
    if (error_ == 0 && (second < 0 || close(second) != 0)) error_ = errno;
    require();
}

}  // namespace pxm::host
