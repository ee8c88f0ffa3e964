#include "host/parts/kept_units.hpp"

#include <fmt/format.h>

#include "host/error.hpp"
#include "host/parts/part_set.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace {

/// Reads all of a part, so that nothing damaged is found when it is too late to make it again.
StoredPart whole_part(const std::string& path) {
    StoredPart part = read_part(path);
    const RegularFile file(path);
    for (const UnitEntry& entry : part.entries) (void)read_payload(file, entry);
    return part;
}

}  // namespace

KeptUnits::KeptUnits(const std::string& folder, const std::string& heading, std::size_t count,
                     const std::string& other, std::string& warnings)
    : places_(count) {
    for (const std::string& path : part_paths(folder)) {
        StoredPart part;
        try {
            part = whole_part(path);
        } catch (const Error& error) {
            warnings += fmt::format("warning: {}: what it holds is made again\n", error.what());
            continue;
        }
        if (part.heading != heading)
            throw Error(ErrorKind::file, fmt::format("{}: {}", printable_path(path), other));
        add(path, part);
    }
}

void KeptUnits::add(const std::string& path) { add(path, read_part(path)); }

void KeptUnits::add(const std::string& path, const StoredPart& part) {
    const auto file = static_cast<std::int32_t>(paths_.size());
    for (const UnitEntry& entry : part.entries)
        if (entry.unit < places_.size()) places_[entry.unit] = {file, entry};
    paths_.push_back(path);
}

std::vector<std::size_t> KeptUnits::missing() const {
    std::vector<std::size_t> missing;
    for (std::size_t i = 0; i < places_.size(); ++i)
        if (places_[i].file < 0) missing.push_back(i);
    return missing;
}

std::string KeptUnits::read(std::size_t unit) const {
    const Place& place = places_[unit];
    const RegularFile file(paths_[static_cast<std::size_t>(place.file)]);
    return read_payload(file, place.entry);
}

}  // namespace pxm::host
