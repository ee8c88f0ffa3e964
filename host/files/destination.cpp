#include "host/files/destination.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/magic.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>

#include "host/error.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace fs = std::filesystem;

namespace {

constexpr int most_links = 40;  // as the system itself follows

std::string folder_of(const std::string& path) {
    const fs::path folder = fs::path(path).parent_path();
    return folder.empty() ? "." : folder.string();
}

std::optional<struct stat> status_of(const std::string& path) {
    struct stat status {};
    if (stat(path.c_str(), &status) != 0) return std::nullopt;
    return status;
}

/// Links of /proc lead to what is open, whatever became of its name: /dev/stdout is one.
bool names_something_open(const std::string& path) {
    struct statfs system {};
    return statfs(folder_of(path).c_str(), &system) == 0 && system.f_type == PROC_SUPER_MAGIC;
}

/// In a folder where all may write, a link may have been laid by somebody for somebody else. The
/// system's own calls do not follow it there (fs.protected_symlinks); nor does this.
bool may_be_planted(const std::string& link, const struct stat& status) {
    const auto folder = status_of(folder_of(link));
    constexpr mode_t shared = S_ISVTX | S_IWOTH;
    return folder && (folder->st_mode & shared) == shared && status.st_uid != geteuid() &&
           status.st_uid != folder->st_uid;
}

/// The path behind links, up to the first that leads to something open.
std::string followed(const std::string& named) {
    std::string path = named;
    for (int links = 0; links < most_links; ++links) {
        struct stat status {};
        if (lstat(path.c_str(), &status) != 0 || !S_ISLNK(status.st_mode)) return path;
        if (names_something_open(path)) return path;
        if (may_be_planted(path, status)) cannot_write(named, "it is somebody else's link");
        std::error_code error;
        const fs::path target = fs::read_symlink(path, error);
        if (error) cannot_write(named, error.message());
        path = (fs::path(folder_of(path)) / target).string();
    }
    cannot_write(named, strerror(ELOOP));
}

/// Why a file in that folder cannot be replaced, or made; empty if it can.
std::string why_not_replaced(const Destination& destination) {
    const std::string folder = destination.folder();
    std::error_code error;
    if (!fs::exists(folder, error)) return "its folder does not exist";
    if (!fs::is_directory(folder, error)) return "its folder is not a directory";
    if (access(folder.c_str(), W_OK | X_OK) != 0) return strerror(errno);
    const auto around = status_of(folder);
    const auto& file = destination.existing;
    if (!file || !around) return "";
    if (file->st_dev != around->st_dev) return "another file system is mounted on it";
    const bool others = file->st_uid != geteuid() && around->st_uid != geteuid();
    if ((around->st_mode & S_ISVTX) != 0 && others && geteuid() != 0) return strerror(EPERM);
    return "";
}

/// The number in /proc/self/fd/N, /dev/fd/N and what links lead there, if it is that open file.
std::optional<int> own_descriptor(const Destination& destination) {
    const std::string name = fs::path(destination.path).filename().string();
    int number = -1;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
    struct stat open_file {};
    if (error != std::errc() || end != name.data() + name.size()) return std::nullopt;
    if (!names_something_open(destination.path) || fstat(number, &open_file) != 0)
        return std::nullopt;
    const bool same = destination.existing && open_file.st_dev == destination.existing->st_dev &&
                      open_file.st_ino == destination.existing->st_ino;
    return same ? std::optional(number) : std::nullopt;
}

}  // namespace

std::string Destination::folder() const { return folder_of(path); }

void cannot_write(const std::string& path, const std::string& why) {
    throw Error(ErrorKind::file, fmt::format("cannot write {}: {}", printable_path(path), why));
}

Destination find_destination(const std::string& path) {
    if (path.empty() || fs::path(path).filename().empty()) cannot_write(path, "it names no file");
    Destination destination;
    destination.named = path;
    destination.path = followed(path);
    destination.existing = status_of(destination.path);
    if (!destination.existing && errno == ENAMETOOLONG) cannot_write(path, strerror(errno));
    const mode_t kind = destination.existing ? destination.existing->st_mode & S_IFMT : S_IFREG;
    if (kind == S_IFDIR) cannot_write(path, "it is a directory");
    if (kind == S_IFBLK) cannot_write(path, "it is a block device");
    if (kind == S_IFSOCK) cannot_write(path, "it is a socket");
    destination.is_file = kind == S_IFREG && !names_something_open(destination.path);
    if (destination.is_file) {
        const std::string why = why_not_replaced(destination);
        if (!why.empty()) cannot_write(path, why);
    } else if (access(destination.path.c_str(), W_OK) != 0) {
        cannot_write(path, strerror(errno));
    }
    return destination;
}

// A descriptor of our own is written to where it stands: opening it anew would begin at its start.
int open_destination(const Destination& destination) {
    const auto own = own_descriptor(destination);
    int descriptor = -1;
    do {
        descriptor = own ? fcntl(*own, F_DUPFD_CLOEXEC, 0)
                         : open(destination.path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
    } while (descriptor < 0 && errno == EINTR);
    if (descriptor < 0) cannot_write(destination.named, strerror(errno));
    return descriptor;
}

}  // namespace pxm::host
