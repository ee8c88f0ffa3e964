// Units that a folder of part files holds, of something that is no picture: as bytes, by number.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host/parts/part_file.hpp"

namespace pxm::host {

class KeptUnits {
  public:
    /// What the folder holds of `count` units with this heading. A file that is damaged counts as
    /// absent, and is named in `warnings`. Throws Error(ErrorKind::file) if the folder cannot be
    /// read or holds parts with another heading: then the message ends with `other`.
    KeptUnits(const std::string& folder, const std::string& heading, std::size_t count,
              const std::string& other, std::string& warnings);

    /// Takes in a file that was written since.
    void add(const std::string& path);
    /// The numbers of the units that are not there.
    [[nodiscard]] std::vector<std::size_t> missing() const;
    /// Throws Error(ErrorKind::file) unless it is as it was written. Precondition: it is there.
    [[nodiscard]] std::string read(std::size_t unit) const;

  private:
    struct Place {
        std::int32_t file = -1;
        UnitEntry entry;
    };

    void add(const std::string& path, const StoredPart& part);

    std::vector<std::string> paths_;
    std::vector<Place> places_;  // by unit
};

}  // namespace pxm::host
