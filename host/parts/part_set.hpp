// Parts of one picture, by their files: which units there are, where, and which are missing.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/parts/part_file.hpp"
#include "host/parts/unit_payload.hpp"

namespace pxm::host {

/// The part files in a folder, sorted by their names. Throws Error(ErrorKind::file) if the folder
/// cannot be read.
[[nodiscard]] std::vector<std::string> part_paths(const std::string& folder);

class PartSet {
  public:
    /// Parts of this picture, none yet.
    explicit PartSet(const PartHeading& heading);

    /// Takes a part in. Throws Error(ErrorKind::file): it is damaged, of another picture, or
    /// differs in a unit from one that was taken before it.
    void add(const std::string& path);
    void add(const std::string& path, const PartReader& part);

    [[nodiscard]] const PartHeading& heading() const { return heading_; }
    [[nodiscard]] const std::vector<UnitPixels>& units() const { return units_; }
    [[nodiscard]] const std::vector<std::string>& paths() const { return paths_; }
    [[nodiscard]] bool has(std::size_t unit) const { return places_[unit].file >= 0; }
    /// The numbers of the units that no part has.
    [[nodiscard]] std::vector<std::size_t> missing() const;
    /// Reads a unit that is there. Throws Error(ErrorKind::file) if it is not as it was written.
    /// `memory` may be the pixels of another unit of these parts.
    [[nodiscard]] StoredUnit read(std::size_t unit, std::vector<PixelRecord> memory = {});
    /// What messages call a unit: "tile 64,128" or "node 17".
    [[nodiscard]] std::string name_of(std::size_t unit) const;

  private:
    struct Place {
        std::int32_t file = -1;
        UnitEntry entry;
    };

    PartHeading heading_;
    std::vector<UnitPixels> units_;
    std::vector<Place> places_;  // by unit
    std::vector<std::string> paths_;
    std::unique_ptr<RegularFile> open_;  // units beside each other are often of one file
    std::int32_t open_file_ = -1;
};

/// All parts of a folder, which are of one picture. Throws Error(ErrorKind::file) also if there is
/// none.
[[nodiscard]] PartSet read_parts(const std::string& folder);

}  // namespace pxm::host
