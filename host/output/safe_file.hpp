// Files that are there whole or not at all: written beside their place, then renamed.
#pragma once

#include <functional>
#include <string>

#include "host/interrupt.hpp"

namespace pxm::host {

/// A file that is being written beside its place: put there by commit(), or else removed.
class PartFile {
  public:
    /// Throws Error(ExitCode::file) unless a file could be written at `path`.
    explicit PartFile(const std::string& path);
    PartFile(const PartFile&) = delete;
    PartFile& operator=(const PartFile&) = delete;
    ~PartFile();

    /// Where to write: in the same folder, with the same extension.
    [[nodiscard]] const std::string& beside() const { return beside_; }
    /// Throws Error(ExitCode::file) if the file cannot be put into place.
    void commit();

  private:
    std::string path_;
    std::string beside_;
    PartFileGuard guard_;
    bool committed_ = false;
};

/// Calls `write` with a path beside `path` (same folder, same extension) and renames what it wrote
/// to `path`. If `write` throws, nothing is left behind and `path` is as before. Throws
/// Error(ExitCode::file) if the file cannot be put into place.
void write_safely(const std::string& path, const std::function<void(const std::string&)>& write);

/// Writes a text file safely.
void write_text_safely(const std::string& path, const std::string& text);

/// Throws Error(ExitCode::file) unless a file could be written at `path`: to be called before work
/// whose result would otherwise be lost.
void require_writable(const std::string& path);

}  // namespace pxm::host
