// Where the frames of a film go if not into files of their own: to ffmpeg, or to the standard
// output.
#pragma once

#include <fmt/format.h>

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "host/engine/frame.hpp"
#include "host/error.hpp"
#include "host/output/raw_frames.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {

/// A frame as bytes of sRGB, put together from its parts.
class ByteFrame {
  public:
    /// A frame of that window, black; the memory of one before is used again.
    void begin(const CropWindow& window);
    /// Any thread, and parts in any order.
    void take(const Frame& part);
    [[nodiscard]] std::span<const unsigned char> bytes() const { return bytes_; }

  private:
    [[nodiscard]] long columns() const { return window_.x1 - window_.x0; }

    CropWindow window_;
    std::vector<unsigned char> bytes_;
};

/// What a scene's film is like.
[[nodiscard]] FilmShape shape_of(const Scene& scene);

/// -o and --format, as they were written.
struct FilmPath {
    std::string out;     // a film, "-", or something else
    std::string format;  // of "-": y4m or ppm
};

/// The stream of a film; null if `path` names no film but pictures. Throws Error: it cannot be
/// written (4), ffmpeg is missing or --format does not fit (2).
[[nodiscard]] std::unique_ptr<FrameStream> open_film_stream(const FilmPath& path,
                                                            const FilmShape& shape);

/// Throws Error(ErrorKind::setting) unless so many frames can be pictures at that path.
void require_frame_number(const std::string& out, std::size_t frames);

/// The frames that --frames names, all if it is empty. Throws Error(ErrorKind::setting).
[[nodiscard]] std::vector<long> frames_of_scene(const std::string& text, const Scene& scene);

/// What `work` returns. An error in it says of which frame it is.
template <class Work>
auto naming_frame(double frame, const Work& work) {
    try {
        return work();
    } catch (const Error& error) {
        throw Error(error.kind(), fmt::format("frame {}: {}", frame, error.what()),
                    error.mistakes());
    }
}

}  // namespace pxm::host
