// A text that a picture carries beside its pixels: in a PNG a chunk iTXt whose keyword is
// pxm_source, in an OpenEXR file string attributes pxm_source_0001 and so on, as letters that stand
// for the deflated text, no more of them in each than ffmpeg 5.1 goes past without losing its place
// (findings/ffmpeg_exr_long_string.sh). What is read is not trusted: its lengths, its stream and
// what it unpacks to are bounded (docs/pictures.md).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/files/regular_file.hpp"

namespace pxm::host {

inline constexpr char carried_name[] = "pxm_source";
inline constexpr std::size_t carried_bytes = std::size_t{1} << 20U;  // of the text

/// The content of the chunk of a PNG. Precondition: at most carried_bytes, in UTF-8.
[[nodiscard]] std::string png_carried(std::string_view text);
/// The attributes of an EXR, names and values. The same precondition.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> exr_carried(std::string_view text);

/// What a PNG or EXR carries; nothing if it carries no such text. Throws Error(ErrorKind::scene)
/// if what it carries is broken or too large, Error(ErrorKind::file) if the file cannot be read.
[[nodiscard]] std::optional<std::string> carried_text(const RegularFile& picture);

}  // namespace pxm::host
