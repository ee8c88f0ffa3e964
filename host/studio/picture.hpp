// A picture on its way to the page: what is known of it, its pixels as a canvas has them, and of
// the machine what every pixel cost.
#pragma once

#include <atomic>
#include <string>

#include "host/studio/asks.hpp"

namespace pxm::host {

/// Renders until `stop` is set, by others or because it takes too long. Throws as render().
[[nodiscard]] RenderResult render_asked(const AskedPicture& asked, int threads,
                                        std::atomic<bool>& stop);

/// Four bytes with the length of the head, lowest first; the head; four bytes a pixel, red, green,
/// blue, 255; of the machine four more a pixel, its cycles, lowest first.
[[nodiscard]] std::string picture_bytes(const std::string& head, const RenderResult& result);

/// The file that `pxm render -o x.png` writes of the frame.
[[nodiscard]] std::string png_bytes(const Frame& frame);

}  // namespace pxm::host
