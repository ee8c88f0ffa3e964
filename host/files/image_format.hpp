// What kind of picture a file is, by its first bytes: a name proves nothing.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace pxm::host {

/// The formats that pxm reads.
enum class ImageFormat { png, jpeg, openexr, tiff, pnm };

/// What the first bytes say. `name` is empty where they say nothing.
struct FoundFormat {
    std::string_view name;
    std::optional<ImageFormat> format;  // absent: pxm does not read it
};

inline constexpr std::size_t image_head_bytes = 32;  // enough for any of them

[[nodiscard]] FoundFormat found_format(std::string_view head);

/// The name of OpenImageIO's reader.
[[nodiscard]] const char* reader_name(ImageFormat format);

}  // namespace pxm::host
