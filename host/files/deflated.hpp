// Bytes as zlib's stream of them, and back within a bound. No stream is trusted: it may be broken,
// or a few bytes that stand for gigabytes.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace pxm::host {

/// The same bytes give the same stream. Throws std::bad_alloc.
[[nodiscard]] std::string deflated(std::string_view bytes);

/// What the stream holds; nothing unless it is one whole stream of at most `most` bytes.
[[nodiscard]] std::optional<std::string> inflated(std::string_view stream, std::size_t most);

}  // namespace pxm::host
