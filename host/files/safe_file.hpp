// Files that are there whole or not at all: written beside their place, then renamed. What is not
// a file (a pipe, a device) is written to instead.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "host/files/checked_file.hpp"
#include "host/files/destination.hpp"
#include "host/process/interrupt.hpp"

namespace pxm::host {

/// What becomes of parts that others left in the folder. Where several computers share it, a lock
/// may not be seen by all of them, and what looks left may be somebody's work.
enum class LeftParts { remove, keep };

/// A file that is being written beside its place: put there by commit(), or else removed.
class PartFile {
  public:
    /// Throws Error(ErrorKind::file) unless a file can be written at `path`. One that is written in
    /// order goes to a pipe or a device at once, any other is copied there when it is whole.
    PartFile(const std::string& path, Places places, LeftParts left = LeftParts::remove);
    PartFile(const PartFile&) = delete;
    PartFile& operator=(const PartFile&) = delete;
    ~PartFile();

    /// Where to write.
    [[nodiscard]] CheckedFile& file() { return *file_; }
    /// The path of it, with the extension of the one that was named: for libraries that open it
    /// themselves. Precondition: places are `any`.
    [[nodiscard]] const std::string& beside() const { return beside_; }
    /// Puts the file into place. Throws Error(ErrorKind::file) if it cannot be put there, or if
    /// anything of it could not be written.
    void commit();

  private:
    void make(LeftParts left);
    void keep_owner_and_mode();
    void copy_to_destination();

    Destination destination_;
    std::string beside_;  // empty: there is none
    std::unique_ptr<CheckedFile> file_;
    std::optional<PartFileGuard> guard_;
};

/// Calls `write` with a file that is put to `path` afterwards. If `write` throws, nothing is left
/// behind and `path` is as before. Throws Error(ErrorKind::file) if the file cannot be written or
/// put into place.
void write_safely(const std::string& path, const std::function<void(CheckedFile&)>& write);

/// Writes a text file safely.
void write_text_safely(const std::string& path, const std::string& text);

/// Throws Error(ErrorKind::file) unless a file could be written at `path`: to be called before work
/// whose result would otherwise be lost.
void require_writable(const std::string& path);

}  // namespace pxm::host
