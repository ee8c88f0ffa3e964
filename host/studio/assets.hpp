// The files of the page, and scenes to begin with, as they are in the program: the build makes the
// .cpp of them (cmake/embed.cmake).
#pragma once

#include <span>
#include <string_view>

namespace pxm::host {

struct Asset {
    std::string_view name;  // of the file, without its folder
    std::string_view bytes;
};

/// host/studio/page/, sorted by name.
[[nodiscard]] std::span<const Asset> page_assets();
/// Scenes of scenes/ that need no other file, sorted by name.
[[nodiscard]] std::span<const Asset> scene_assets();

/// Null if there is none of that name.
[[nodiscard]] const Asset* find_asset(std::span<const Asset> assets, std::string_view name);
/// The media type of a file of the page.
[[nodiscard]] std::string_view media_type(std::string_view name);

}  // namespace pxm::host
