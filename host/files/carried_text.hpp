// A text that a picture carries beside its pixels: in a PNG a chunk iTXt whose keyword is
// pxm_source, in an OpenEXR file a string attribute of that name, as letters that stand for the
// deflated text. What is read is not trusted: its lengths, its stream and what it unpacks to are
// bounded (docs/pictures.md).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "host/files/regular_file.hpp"

namespace pxm::host {

inline constexpr char carried_name[] = "pxm_source";
inline constexpr std::size_t carried_bytes = std::size_t{1} << 20U;  // of the text

/// The content of the chunk of a PNG. Precondition: at most carried_bytes, in UTF-8.
[[nodiscard]] std::string png_carried(std::string_view text);
/// The value of the attribute of an EXR. The same precondition.
[[nodiscard]] std::string exr_carried(std::string_view text);

/// What a PNG or EXR carries; nothing if it carries no such text. Throws Error(ErrorKind::scene)
/// if what it carries is broken or too large, Error(ErrorKind::file) if the file cannot be read.
[[nodiscard]] std::optional<std::string> carried_text(const RegularFile& picture);

}  // namespace pxm::host
