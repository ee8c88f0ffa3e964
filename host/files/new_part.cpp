#include "host/files/new_part.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string_view>

#include "host/files/folder_names.hpp"

namespace pxm::host {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view prefix = ".pxm-part-";
constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyz234567";  // 5 bits each
constexpr std::size_t random_letters = 12;
constexpr std::size_t most_extension_bytes = 16;
constexpr int most_tries = 100;

/// A name that nobody else has or can guess; empty if the system has no random numbers.
std::string random_name(const std::string& extension) {
    std::array<unsigned char, random_letters> bytes{};
    if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) return "";
    std::string name(prefix);
    for (const unsigned char byte : bytes) name += letters[byte % letters.size()];
    return extension.size() <= most_extension_bytes ? name + extension : name;
}

bool is_part_name(std::string_view name) {
    if (!name.starts_with(prefix)) return false;
    name.remove_prefix(prefix.size());
    return name.size() >= random_letters && name.find_first_not_of(letters) >= random_letters &&
           (name.size() == random_letters || name.substr(random_letters).starts_with('.'));
}

/// Whether the path still is a name of the open file.
bool is_at(int descriptor, const std::string& path) {
    struct stat open_file {
    }, named{};
    return fstat(descriptor, &open_file) == 0 && lstat(path.c_str(), &named) == 0 &&
           open_file.st_dev == named.st_dev && open_file.st_ino == named.st_ino;
}

/// Between making a part and locking it another run may have taken it for a left one.
bool lock(const NewPart& part) {
    const bool taken = flock(part.descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    return !taken && is_at(part.descriptor, part.path);
}

bool is_own_file(int descriptor) {
    struct stat status {};
    return fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) && status.st_uid == geteuid();
}

/// Network file systems lock only what is open for writing.
int open_left(const std::string& path) {
    constexpr int flags = O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC;
    const int descriptor = open(path.c_str(), O_RDWR | flags);
    return descriptor >= 0 ? descriptor : open(path.c_str(), O_RDONLY | flags);
}

void remove_if_left(const std::string& path) {
    const int descriptor = open_left(path);
    if (descriptor < 0) return;
    if (is_own_file(descriptor) && flock(descriptor, LOCK_EX | LOCK_NB) == 0 &&
        is_at(descriptor, path)) {
        unlink(path.c_str());
    }
    close(descriptor);
}

}  // namespace

NewPart make_part(const std::string& folder, const std::string& extension, mode_t mode) {
    constexpr int flags = O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
    NewPart part;
    for (int i = 0; i < most_tries; ++i) {
        const std::string name = random_name(extension);
        part.path = (fs::path(folder) / name).string();
        part.descriptor = name.empty() ? -1 : open(part.path.c_str(), flags, mode);
        if (part.descriptor >= 0) {
            if (lock(part)) return part;
            close(part.descriptor);
        } else if (errno != EEXIST && errno != EINTR) {
            break;
        }
    }
    part.error = strerror(errno);
    return part;
}

void remove_left_parts(const std::string& folder) {
    std::error_code error;
    for (const std::string& name : names_in(folder, error)) {
        if (is_part_name(name)) remove_if_left((fs::path(folder) / name).string());
    }
}

}  // namespace pxm::host
