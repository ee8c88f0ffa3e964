// The sizes that an OpenEXR file claims, read before the library sees the file: it sets memory
// aside for lines and tiles as soon as it opens one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/files/regular_file.hpp"

namespace pxm::host {

/// Of one part. Nothing here was checked.
struct ExrSizes {
    std::int64_t width = 0;  // of the data window
    std::int64_t height = 0;
    std::int64_t channels = 0;
    std::int64_t tile_width = 0;  // 0: lines
    std::int64_t tile_height = 0;
};

/// The largest of each over a file's parts. Throws Error(ErrorKind::file) with "PATH: why" if the
/// header is not one.
[[nodiscard]] ExrSizes largest_exr_sizes(const RegularFile& file);

/// A text that stands in several attributes of the first part.
struct ExrText {
    bool there = false;
    std::optional<std::string> text;  // absent: an attribute is no string, or all are more bytes
};

/// The attributes whose names start with `start`, in the order of their names, as one text of at
/// most `most` bytes. Throws as largest_exr_sizes().
[[nodiscard]] ExrText exr_text(const RegularFile& file, std::string_view start, std::size_t most);

}  // namespace pxm::host
