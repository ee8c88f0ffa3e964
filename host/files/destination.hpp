// What a path names before anything is written there: a file to be replaced or made, or something
// that is not a file (a pipe, a terminal, the null device), which is written to and never replaced.
#pragma once

#include <sys/stat.h>

#include <optional>
#include <string>

namespace pxm::host {

struct Destination {
    std::string named;  // as the user wrote it
    std::string path;   // links are followed: where the file is or will be
    bool is_file = true;
    std::optional<struct stat> existing;

    /// Its folder; a part beside it can be renamed to it.
    [[nodiscard]] std::string folder() const;
};

/// Throws Error(ErrorKind::file) with the reason unless something can be written there.
[[nodiscard]] Destination find_destination(const std::string& path);

/// Opens what is not a file for writing; waits for a reader where a pipe wants one. Throws
/// Error(ErrorKind::file).
[[nodiscard]] int open_destination(const Destination& destination);

[[noreturn]] void cannot_write(const std::string& path, const std::string& why);

}  // namespace pxm::host
