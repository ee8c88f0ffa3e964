// A regular file that is open for reading. What is asked of it and what is read from it is one and
// the same file, whatever becomes of its name meanwhile.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace pxm::host {

/// Never waits: a pipe, a device or a folder is refused before anything is read.
class RegularFile {
  public:
    /// Throws Error(ErrorKind::file) with "PATH: why".
    explicit RegularFile(const std::string& path) : RegularFile(path, path) {}
    /// The file at `place`, which messages call `path`.
    RegularFile(const std::string& place, const std::string& path);
    ~RegularFile();
    RegularFile(const RegularFile&) = delete;
    RegularFile& operator=(const RegularFile&) = delete;

    [[nodiscard]] const std::string& path() const { return path_; }  // as messages call it
    [[nodiscard]] int descriptor() const { return descriptor_; }     // of the open file
    /// Its size when it was opened.
    [[nodiscard]] std::uint64_t bytes() const { return bytes_; }
    /// At most `count` bytes from `offset`; fewer where the file ends. Throws as the constructor.
    [[nodiscard]] std::string read(std::uint64_t offset, std::size_t count) const;

  private:
    [[noreturn]] void refuse(const std::string& why) const;

    std::string path_;
    int descriptor_ = -1;
    std::uint64_t bytes_ = 0;
};

inline constexpr std::size_t text_bytes = std::size_t{64} << 20U;  // of a file that is text

/// A file's whole text. What is not a regular file, or larger than text_bytes, is an
/// Error(ErrorKind::file).
[[nodiscard]] std::string read_file(const std::string& path);
/// The same of a file at `place`, which messages call `path`.
[[nodiscard]] std::string read_file(const std::string& place, const std::string& path);

}  // namespace pxm::host
