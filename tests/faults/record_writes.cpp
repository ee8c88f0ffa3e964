// Preloaded into the program (LD_PRELOAD), writes down in their order the calls that change files
// below a folder, for tests/faults/power_loss, which asks what a disk would hold had the power
// failed at any of them:
//   RECORD_ROOT   the folder, by its real path
//   RECORD_TO     the file of records, outside of the folder
//   RECORD_NO_SYNC  set: no fsync is written down, as if the program made none
// A record is a line, and behind that of a write so many bytes:
//   create FILE PATH | write FILE OFFSET BYTES | size FILE BYTES | sync FILE | sync_folder PATH
//   rename FROM TO | unlink PATH | mkdir PATH | rmdir PATH
// FILE is the inode; a record `create` begins a new file, whatever had its number before.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <unistd.h>

#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <string>

namespace {

std::recursive_mutex& order() {
    static std::recursive_mutex mutex;
    return mutex;
}

const std::string& root() {
    static const std::string path = std::getenv("RECORD_ROOT") ? std::getenv("RECORD_ROOT") : "";
    return path;
}

void put(const void* bytes, std::size_t count) {
    static const int file = static_cast<int>(
        syscall(SYS_openat, AT_FDCWD, std::getenv("RECORD_TO") ? std::getenv("RECORD_TO") : "",
                O_CREAT | O_WRONLY | O_APPEND | O_CLOEXEC, 0600));
    const char* from = static_cast<const char*>(bytes);
    while (count > 0) {
        const long written = syscall(SYS_write, file, from, count);
        if (written <= 0) _exit(99);
        from += written;
        count -= static_cast<std::size_t>(written);
    }
}

void put_line(const std::string& line) { put((line + '\n').data(), line.size() + 1); }

/// The path from the root on; empty if it is not below it.
std::string below(const std::string& path) {
    if (root().empty()) return "";
    std::string whole = path;
    if (!whole.starts_with('/')) {
        char here[4096];
        if (syscall(SYS_getcwd, here, sizeof here) < 0) return "";
        whole = std::string(here) + '/' + path;
    }
    for (std::size_t at; (at = whole.find("/./")) != std::string::npos;) whole.erase(at, 2);
    for (std::size_t at; (at = whole.find("//")) != std::string::npos;) whole.erase(at, 1);
    while (whole.ends_with('/') && whole.size() > 1) whole.pop_back();
    if (whole.ends_with("/.")) whole.resize(whole.size() - 2);
    if (whole == root()) return ".";
    return whole.starts_with(root() + '/') ? whole.substr(root().size() + 1) : "";
}

/// The path of an open file.
std::string path_of(int file) {
    char path[4096];
    const std::string link = "/proc/self/fd/" + std::to_string(file);
    const long bytes = syscall(SYS_readlink, link.c_str(), path, sizeof path);
    return bytes > 0 ? std::string(path, static_cast<std::size_t>(bytes)) : "";
}

struct Known {
    bool is_below = false;
    bool is_folder = false;
    unsigned long inode = 0;
    long size = 0;
    std::string path;
};

Known known(int file) {
    Known result;
    struct stat status {};
    if (root().empty() || fstat(file, &status) != 0) return result;
    result.is_folder = S_ISDIR(status.st_mode);
    if (!result.is_folder && !S_ISREG(status.st_mode)) return result;
    result.path = below(path_of(file));
    result.is_below = !result.path.empty();
    result.inode = status.st_ino;
    result.size = status.st_size;
    return result;
}

bool exists(const char* path) {
    struct stat status {};
    return lstat(path, &status) == 0;
}

int opened(int folder, const char* path, int flags, mode_t mode) {
    const std::lock_guard lock(order());
    const bool writes = (flags & (O_CREAT | O_TRUNC)) != 0 && folder == AT_FDCWD;
    const bool was_there = !writes || exists(path);
    const auto file = static_cast<int>(syscall(SYS_openat, folder, path, flags, mode));
    if (file < 0 || !writes) return file;
    const Known what = known(file);
    if (!what.is_below) return file;
    if (!was_there) put_line("create " + std::to_string(what.inode) + ' ' + what.path);
    if (was_there && (flags & O_TRUNC) != 0) put_line("size " + std::to_string(what.inode) + " 0");
    return file;
}

void note_write(int file, long offset, const void* bytes, ssize_t count) {
    if (count <= 0) return;
    const Known what = known(file);
    if (!what.is_below) return;
    put_line("write " + std::to_string(what.inode) + ' ' + std::to_string(offset) + ' ' +
             std::to_string(count));
    put(bytes, static_cast<std::size_t>(count));
}

/// Where the next write goes.
long place_of(int file) {
    const long flags = syscall(SYS_fcntl, file, F_GETFL);
    if (flags >= 0 && (flags & O_APPEND) != 0) return known(file).size;
    return syscall(SYS_lseek, file, 0L, SEEK_CUR);
}

int note(long result, const std::string& line) {
    if (result == 0) put_line(line);
    return static_cast<int>(result);
}

int synced(int file, long call) {
    const std::lock_guard lock(order());
    const long result = syscall(call, file);
    const Known what = known(file);
    if (result == 0 && what.is_below && std::getenv("RECORD_NO_SYNC") == nullptr)
        put_line(what.is_folder ? "sync_folder " + what.path
                                : "sync " + std::to_string(what.inode));
    return static_cast<int>(result);
}

int removed(const char* path, bool folder) {
    const std::lock_guard lock(order());
    const std::string from = below(path);
    const long result = syscall(SYS_unlinkat, AT_FDCWD, path, folder ? AT_REMOVEDIR : 0);
    if (from.empty()) return static_cast<int>(result);
    return note(result, (folder ? "rmdir " : "unlink ") + from);
}

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
    va_list rest;
    va_start(rest, flags);
    const mode_t mode = (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(rest, mode_t) : 0;
    va_end(rest);
    return opened(AT_FDCWD, path, flags, mode);
}
int open64(const char* path, int flags, ...) {
    va_list rest;
    va_start(rest, flags);
    const mode_t mode = (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(rest, mode_t) : 0;
    va_end(rest);
    return opened(AT_FDCWD, path, flags, mode);
}
int openat(int folder, const char* path, int flags, ...) {
    va_list rest;
    va_start(rest, flags);
    const mode_t mode = (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(rest, mode_t) : 0;
    va_end(rest);
    return opened(folder, path, flags, mode);
}

ssize_t write(int file, const void* bytes, std::size_t count) {
    const std::lock_guard lock(order());
    const long at = place_of(file);
    const ssize_t written = syscall(SYS_write, file, bytes, count);
    note_write(file, at, bytes, written);
    return written;
}
ssize_t pwrite(int file, const void* bytes, std::size_t count, off_t at) {
    const std::lock_guard lock(order());
    const ssize_t written = syscall(SYS_pwrite64, file, bytes, count, at);
    note_write(file, at, bytes, written);
    return written;
}
ssize_t pwrite64(int file, const void* bytes, std::size_t count, off_t at) {
    return pwrite(file, bytes, count, at);
}
ssize_t writev(int file, const iovec* pieces, int count) {
    ssize_t all = 0;
    for (int i = 0; i < count; ++i) {
        const ssize_t written = write(file, pieces[i].iov_base, pieces[i].iov_len);
        if (written < 0) return all > 0 ? all : written;
        all += written;
        if (static_cast<std::size_t>(written) < pieces[i].iov_len) break;
    }
    return all;
}
int ftruncate(int file, off_t size) {
    const std::lock_guard lock(order());
    const Known what = known(file);
    const long result = syscall(SYS_ftruncate, file, size);
    if (!what.is_below) return static_cast<int>(result);
    return note(result, "size " + std::to_string(what.inode) + ' ' + std::to_string(size));
}
int ftruncate64(int file, off_t size) { return ftruncate(file, size); }
int fsync(int file) { return synced(file, SYS_fsync); }
int fdatasync(int file) { return synced(file, SYS_fdatasync); }

int rename(const char* from, const char* to) {
    const std::lock_guard lock(order());
    const std::string line = "rename " + below(from) + ' ' + below(to);
    const bool is_below = !below(from).empty();
    const long result = syscall(SYS_rename, from, to);
    return is_below ? note(result, line) : static_cast<int>(result);
}
int link(const char* from, const char* to) {
    const std::lock_guard lock(order());
    const std::string line = "link " + below(from) + ' ' + below(to);
    const bool is_below = !below(from).empty();
    const long result = syscall(SYS_link, from, to);
    return is_below ? note(result, line) : static_cast<int>(result);
}
int unlink(const char* path) { return removed(path, false); }
int rmdir(const char* path) { return removed(path, true); }
int remove(const char* path) {
    struct stat status {};
    return removed(path, lstat(path, &status) == 0 && S_ISDIR(status.st_mode));
}
int mkdir(const char* path, mode_t mode) {
    const std::lock_guard lock(order());
    const std::string line = "mkdir " + below(path);
    const bool is_below = !below(path).empty();
    const long result = syscall(SYS_mkdir, path, mode);
    return is_below ? note(result, line) : static_cast<int>(result);
}

}  // extern "C"
