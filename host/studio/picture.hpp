// A picture on its way to the page: its pixels as a canvas has them, made by the threads that
// render; what is known of it; and of the machine what every pixel cost.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "host/studio/asks.hpp"

namespace pxm::host {

struct Picture {
    RenderResult result;                // without its frame
    std::vector<unsigned char> rgba;    // red, green, blue, 255
    std::vector<std::uint32_t> cycles;  // of the machine's pixels
};

/// Renders until `stop` is set, by others or because it takes too long. Throws as
/// render(). `progress` hears the share that is done, from any thread.
[[nodiscard]] Picture render_asked(const AskedPicture& asked, int threads, std::atomic<bool>& stop,
                                   const std::function<void(double)>& progress = {});

/// Four bytes with the length of the head, lowest first; the head; four bytes a pixel; of the
/// machine four more a pixel, its cycles, lowest first.
[[nodiscard]] std::string picture_bytes(const std::string& head, const Picture& picture);

/// The file that `pxm render -o x.png` writes of it.
[[nodiscard]] std::string png_bytes(const Picture& picture);

}  // namespace pxm::host
