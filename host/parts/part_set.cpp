#include "host/parts/part_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "host/error.hpp"
#include "host/files/folder_names.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
    throw Error(ErrorKind::file, fmt::format("{}: {}", printable_path(path), why));
}

}  // namespace

std::vector<std::string> part_paths(const std::string& folder) {
    std::error_code error;
    std::vector<std::string> paths;
    for (const std::string& name : names_in(folder, error)) {
        if (!name.starts_with('.') && name.ends_with(part_ending))
            paths.push_back((fs::path(folder) / name).string());
    }
    if (error) refuse(folder, error.message());
    std::ranges::sort(paths);
    return paths;
}

PartSet::PartSet(const PartHeading& heading)
    : heading_(heading), units_(units_of(heading.grid)), places_(units_.size()) {}

void PartSet::add(const std::string& path) { add(path, PartReader(path)); }

void PartSet::add(const std::string& path, const PartReader& part) {
    const std::string why = why_apart(part.heading(), heading_);
    if (!why.empty()) {
        refuse(path, "is a part of another picture" +
                         (paths_.empty() ? "" : " than " + printable_path(paths_.front())) + " (" +
                         why + ")");
    }
    const auto file = static_cast<std::int32_t>(paths_.size());
    for (const UnitEntry& entry : part.entries()) {
        if (entry.unit >= places_.size()) refuse(path, "is damaged");
        Place& place = places_[entry.unit];
        const UnitEntry& before = place.entry;
        if (place.file < 0) {
            place = {file, entry};
        } else if (before.digest != entry.digest || before.bytes != entry.bytes) {
            refuse(path, fmt::format("{} is not as in {}", name_of(entry.unit),
                                     printable_path(paths_[static_cast<std::size_t>(place.file)])));
        }
    }
    paths_.push_back(path);
}

std::vector<std::size_t> PartSet::missing() const {
    std::vector<std::size_t> missing;
    for (std::size_t i = 0; i < places_.size(); ++i)
        if (places_[i].file < 0) missing.push_back(i);
    return missing;
}

StoredUnit PartSet::read(std::size_t unit, std::vector<PixelRecord> memory) {
    const Place& place = places_[unit];
    const std::string& path = paths_[static_cast<std::size_t>(place.file)];
    if (open_file_ != place.file) {
        open_ = std::make_unique<RegularFile>(path);
        open_file_ = place.file;
    }
    auto stored = unit_of_payload(read_payload(*open_, place.entry), units_[unit].count(),
                                  heading_.channels, std::move(memory));
    if (!stored) refuse(path, "is damaged");
    return *std::move(stored);
}

std::string PartSet::name_of(std::size_t unit) const {
    if (heading_.grid.of_nodes()) return fmt::format("node {}", unit);
    return fmt::format("the tile at {},{}", units_[unit].x0, units_[unit].y0);
}

PartSet read_parts(const std::string& folder) {
    const std::vector<std::string> paths = part_paths(folder);
    if (paths.empty()) refuse(folder, fmt::format("holds no parts (*{})", part_ending));
    const PartReader first(paths.front());
    PartSet parts(first.heading());
    parts.add(paths.front(), first);
    for (std::size_t i = 1; i < paths.size(); ++i) parts.add(paths[i]);
    return parts;
}

}  // namespace pxm::host
