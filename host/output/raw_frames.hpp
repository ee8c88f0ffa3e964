// Frames one after another as other programs take them from a pipe: YUV4MPEG2 (y4m) or binary PPM.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "host/files/checked_file.hpp"

namespace pxm::host {

enum class RawFormat { y4m, ppm };

/// What all frames have in common.
struct FilmShape {
    long columns = 0;
    long rows = 0;
    double rate = 25;  // frames a second
};

/// Takes frames as bytes of sRGB, three a pixel, by rows.
class FrameStream {
  public:
    virtual ~FrameStream() = default;
    virtual void frame(std::span<const unsigned char> rgb) = 0;
    /// After the last frame.
    virtual void finish() = 0;
};

/// `file` must outlive it. A y4m is in 4:4:4, limited range, by the matrix of BT.709: sRGB has the
/// primaries of that. Throws Error(ErrorKind::file), as all of it.
[[nodiscard]] std::unique_ptr<FrameStream> make_raw_stream(CheckedFile& file, RawFormat format,
                                                           const FilmShape& shape);

}  // namespace pxm::host
