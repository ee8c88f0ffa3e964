// A file that is dropped on the page: other people's fractals as the text of a scene that is not
// saved.
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <vector>

namespace pxm::host {

inline constexpr std::size_t brought_bytes = 1'400'000;  // so that it fits into a request as base64

struct BroughtFile {
    std::string name;
    std::string bytes;
    std::optional<std::string> entry;  // of a file that holds several
    int maps = 4;                      // to be looked for in a picture
};

struct MadeScene {
    std::string name;  // of the file that it may be saved as
    std::string text;
    std::string messages;
};

/// As `pxm import` makes it; what has to be searched for is searched for a few seconds. Throws
/// Error as import_file.
[[nodiscard]] MadeScene scene_from(const BroughtFile& brought, const std::atomic<bool>& stop);

/// The bytes of a text in base64; nothing if it is not that.
[[nodiscard]] std::optional<std::string> bytes_of_base64(const std::string& text);

}  // namespace pxm::host
