#include "host/files/regular_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "host/error.hpp"

namespace pxm::host {

RegularFile::RegularFile(const std::string& place, const std::string& path) : path_(path) {
    // O_NONBLOCK: opening a pipe that nobody writes to would wait for ever.
    do {
        descriptor_ = ::open(place.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
    } while (descriptor_ < 0 && errno == EINTR);
    if (descriptor_ < 0)
        refuse(errno == ENOENT || errno == ENOTDIR ? "no such file" : "cannot be opened");
    struct stat status {};
    const bool known = ::fstat(descriptor_, &status) == 0;
    if (known && S_ISREG(status.st_mode)) {
        bytes_ = static_cast<std::uint64_t>(status.st_size);
        return;
    }
    ::close(descriptor_);
    refuse(known && S_ISDIR(status.st_mode) ? "is a directory" : "not a regular file");
}

RegularFile::~RegularFile() { ::close(descriptor_); }

std::string RegularFile::read(std::uint64_t offset, std::size_t count) const {
    std::string data(count, '\0');
    std::size_t done = 0;
    while (done < count) {
        const ssize_t got = ::pread(descriptor_, data.data() + done, count - done,
                                    static_cast<off_t>(offset + done));
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) refuse("cannot be read");
        if (got == 0) break;
        done += static_cast<std::size_t>(got);
    }
    data.resize(done);
    return data;
}

void RegularFile::refuse(const std::string& why) const {
    throw Error(ErrorKind::file, fmt::format("{}: {}", path_, why));
}

std::string read_file(const std::string& path) { return read_file(path, path); }

std::string read_file(const std::string& place, const std::string& path) {
    const RegularFile file(place, path);
    if (file.bytes() > text_bytes)
        throw Error(ErrorKind::file, fmt::format("{}: larger than {} MB", path, text_bytes >> 20U));
    return file.read(0, static_cast<std::size_t>(file.bytes()));
}

}  // namespace pxm::host
