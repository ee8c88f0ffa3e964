#include "host/parts/part_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

#include "host/error.hpp"
#include "host/parts/heading_json.hpp"
#include "host/text/digest.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace {

constexpr std::string_view first_line = "pxm part 1\n";
constexpr std::uint64_t last_word = 0x0a74'7261'706d'7870;  // "pxmpart\n"

/// The file's last bytes.
struct Ending {
    std::uint64_t head_bytes = 0;  // the first line and the heading
    std::uint64_t entries_at = 0;
    std::uint64_t entries = 0;
    std::uint64_t digest = 0;  // of head and entries
    std::uint64_t word = last_word;
};

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
    throw Error(ErrorKind::file, fmt::format("{}: {}", printable_path(path), why));
}

std::string_view bytes_of(const std::vector<UnitEntry>& entries) {
    return {reinterpret_cast<const char*>(entries.data()), entries.size() * sizeof(UnitEntry)};
}

std::uint64_t digest_of_all(std::string_view head, std::string_view entries) {
    return digest_of(head) ^ digest_of(entries) * 3;  // not a sum of two that could change places
}

/// The ending of a file that is as long as it says.
Ending ending_of(const RegularFile& file) {
    Ending ending;
    const std::string line = file.read(0, first_line.size());
    if (line != first_line) refuse(file.path(), "is no part of a picture");
    const std::uint64_t size = file.bytes();
    const std::string bytes =
        size < sizeof ending ? "" : file.read(size - sizeof ending, sizeof ending);
    if (bytes.size() == sizeof ending) std::memcpy(&ending, bytes.data(), sizeof ending);
    const std::uint64_t most = size / sizeof(UnitEntry);
    const bool whole =
        bytes.size() == sizeof ending && ending.word == last_word && ending.entries <= most &&
        ending.head_bytes <= text_bytes && ending.head_bytes <= ending.entries_at &&
        ending.entries_at <= size &&
        ending.entries_at + ending.entries * sizeof(UnitEntry) + sizeof ending == size;
    if (!whole) refuse(file.path(), "was cut short");
    return ending;
}

}  // namespace

PartWriter::PartWriter(const std::string& path, const PartHeading& heading)
    : PartWriter(path, heading_json(heading)) {}

PartWriter::PartWriter(const std::string& path, const std::string& heading)
    : path_(path),
      file_(path, Places::in_order, LeftParts::keep),
      head_(std::string(first_line) + heading + "\n"),
      end_(head_.size()) {
    file_.file().append(head_.data(), head_.size());
}

void PartWriter::add(std::size_t unit, const std::string& payload) {
    file_.file().append(payload.data(), payload.size());
    entries_.push_back({unit, end_, payload.size(), digest_of(payload)});
    end_ += payload.size();
}

void PartWriter::finish() {
    std::ranges::sort(entries_, {}, &UnitEntry::unit);
    if (is_there()) return;
    const std::string_view entries = bytes_of(entries_);
    const Ending ending{head_.size(), end_, entries_.size(), digest_of_all(head_, entries),
                        last_word};
    file_.file().append(entries.data(), entries.size());
    file_.file().append(&ending, sizeof ending);
    file_.commit();
}

bool PartWriter::is_there() const {
    std::error_code none;
    if (!std::filesystem::exists(path_, none)) return false;
    std::optional<StoredPart> there;
    try {
        there = read_part(path_);
    } catch (const Error&) {
        return false;
    }
    const auto same = [](const UnitEntry& a, const UnitEntry& b) {
        return a.unit == b.unit && a.bytes == b.bytes && a.digest == b.digest;
    };
    const auto [own, other] = std::ranges::mismatch(entries_, there->entries, same);
    if (own == entries_.end() && other == there->entries.end()) return true;
    const UnitEntry& unit = own == entries_.end() ? *other : *own;
    refuse(path_, fmt::format("somebody made this part otherwise: unit {} of the picture differs",
                              unit.unit));
}

StoredPart read_part(const std::string& path) {
    const RegularFile file(path);
    const Ending ending = ending_of(file);
    const std::string head = file.read(0, ending.head_bytes);
    const std::string entries = file.read(ending.entries_at, ending.entries * sizeof(UnitEntry));
    if (digest_of_all(head, entries) != ending.digest) refuse(path, "is damaged");
    StoredPart part;
    part.heading = head.substr(first_line.size(), head.size() - first_line.size() - 1);
    part.entries.resize(ending.entries);
    if (!entries.empty()) std::memcpy(part.entries.data(), entries.data(), entries.size());
    for (const UnitEntry& entry : part.entries)
        if (entry.at > ending.entries_at || entry.bytes > ending.entries_at - entry.at)
            refuse(path, "is damaged");
    return part;
}

PartReader::PartReader(const std::string& path) {
    StoredPart part = read_part(path);
    entries_ = std::move(part.entries);
    try {
        heading_ = heading_of_json(part.heading);
    } catch (const std::exception&) {
        refuse(path, "was written by another version of pxm");
    }
}

std::optional<PartReader> find_part(const std::string& path, std::string& why) {
    std::error_code none;
    if (!std::filesystem::exists(path, none)) return std::nullopt;
    try {
        return PartReader(path);
    } catch (const Error& error) {
        why = error.what();
        return std::nullopt;
    }
}

std::string read_payload(const RegularFile& file, const UnitEntry& entry) {
    std::string bytes = file.read(entry.at, entry.bytes);
    if (bytes.size() != entry.bytes || digest_of(bytes) != entry.digest)
        refuse(file.path(), "is damaged");
    return bytes;
}

}  // namespace pxm::host
