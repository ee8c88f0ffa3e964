// A picture that a page asks for: block by block for its canvas, or as a file.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "host/studio/asks.hpp"

namespace pxm::host {

/// Renders until `stop` is set. `progress` hears which share is done, from any thread. Throws as
/// render().
[[nodiscard]] RenderResult render_asked(const AskedPicture& asked, int threads,
                                        std::atomic<bool>& stop,
                                        const std::function<void(double)>& progress,
                                        PictureTaker& taker);

struct Picture {
    RenderResult result;             // without its frame
    std::vector<unsigned char> rgb;  // three bytes a pixel
};

/// The same, kept.
[[nodiscard]] Picture picture_asked(const AskedPicture& asked, int threads, std::atomic<bool>& stop,
                                    const std::function<void(double)>& progress = {});

/// The file that `pxm render -o x.png` writes of it.
[[nodiscard]] std::string png_bytes(const Picture& picture);

}  // namespace pxm::host
