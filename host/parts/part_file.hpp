// A file with finished units of a picture: a part of it. In order: a line that says what it is; the
// heading, one line of JSON; the units' bytes; where each of them lies, with its digest, by their
// numbers; and at the end how long these are and the digest of all but the units. So a file that
// was cut short or changed is known at once, a changed unit when it is read, and a unit is found
// without reading the others. Numbers are little endian.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/files/regular_file.hpp"
#include "host/files/safe_file.hpp"
#include "host/parts/part_heading.hpp"

namespace pxm::host {

inline constexpr const char* part_ending = ".pxmpart";  // of the file's name

/// Where a unit lies in its file.
struct UnitEntry {
    std::uint64_t unit = 0;  // its number in the grid
    std::uint64_t at = 0;
    std::uint64_t bytes = 0;
    std::uint64_t digest = 0;
};

/// A part file that is being written: there whole or not at all.
class PartWriter {
  public:
    /// Throws Error(ErrorKind::file), as do the other functions.
    PartWriter(const std::string& path, const PartHeading& heading);
    /// With a heading that is not of a picture, one line.
    PartWriter(const std::string& path, const std::string& heading);

    void add(std::size_t unit, const std::string& payload);
    /// Puts the file into its place, unless somebody else put the same part there meanwhile. Throws
    /// if that differs; what is damaged is replaced.
    void finish();

  private:
    [[nodiscard]] bool is_there() const;

    std::string path_;
    PartFile file_;
    std::string head_;
    std::vector<UnitEntry> entries_;
    std::uint64_t end_ = 0;
};

/// What a part file holds, whatever it is a part of.
struct StoredPart {
    std::string heading;
    std::vector<UnitEntry> entries;
};
/// Throws Error(ErrorKind::file) if it cannot be read, or is not as it was written.
[[nodiscard]] StoredPart read_part(const std::string& path);

/// A part file of a picture that is there.
class PartReader {
  public:
    /// Throws Error(ErrorKind::file) if it cannot be read, or is not as it was written.
    explicit PartReader(const std::string& path);

    [[nodiscard]] const PartHeading& heading() const { return heading_; }
    [[nodiscard]] const std::vector<UnitEntry>& entries() const { return entries_; }

  private:
    PartHeading heading_;
    std::vector<UnitEntry> entries_;
};

/// The part at `path`; empty if there is none, or it is not as it was written: then `why` says so.
[[nodiscard]] std::optional<PartReader> find_part(const std::string& path, std::string& why);

/// A unit's bytes. Throws Error(ErrorKind::file) unless they are as they were written.
[[nodiscard]] std::string read_payload(const RegularFile& file, const UnitEntry& entry);

}  // namespace pxm::host
