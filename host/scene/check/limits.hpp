// The largest scene that is taken (docs/scene-language.md, "Ranges").
#pragma once

#include <cstddef>

namespace pxm::host {

inline constexpr std::size_t maps_an_ifs = 65'536;
inline constexpr std::size_t maps_a_scene = 1'000'000;
inline constexpr long image_side_pixels = 65'536;
inline constexpr long heap_entries = 65'536;
inline constexpr long samples_a_pixel = 65'536;
inline constexpr long mirror_bounces = 64;
inline constexpr long frames_a_film = 1'000'000;
inline constexpr int include_depth = 32;
inline constexpr std::size_t files_a_scene = 1'000;
inline constexpr std::size_t text_bytes_a_scene = std::size_t{256} << 20U;
inline constexpr std::size_t pictures_a_scene = 256;
inline constexpr long texels_a_scene = 4L * 4096 * 4096;  // pixels of all its pictures

}  // namespace pxm::host
