// Pictures as they are read. Only regular files of the formats of host/files/image_format.hpp, told
// by their content, are given to OpenImageIO, and only when what they claim to hold is within the
// limits below: no name makes it open an address or a plug-in, no number its memory grow.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "host/files/picture_library.hpp"

namespace pxm::host {

/// All that is known of a picture but its pixels.
struct ImageHeader {
    int width = 0;
    int height = 0;
    std::vector<std::string> channels;
    Metadata metadata;
    bool srgb = false;  // the values go through the sRGB curve

    /// The index of a channel, or -1.
    [[nodiscard]] int channel(const std::string& name) const;
    [[nodiscard]] const std::string* find(const std::string& name) const;
};

/// The largest picture that is read; both are at most what ImageReader can do, row by row.
struct ImageLimits {
    long side_pixels;
    long pixels;
};

inline constexpr ImageLimits any_image{65'536, 65'536L * 65'536};  // as large as pxm writes
/// Of a picture that is kept whole: a texture, or one to import.
inline constexpr ImageLimits kept_image{16'384, 4096L * 4096};

inline constexpr long row_values = 1L << 20;  // width times channels, also of tiles together
inline constexpr int most_channels = 256;
/// JPEG, TIFF, PNM and interlaced PNG may be unpacked at once before their first row is known.
inline constexpr long unpacked_pixels = 8192L * 8192;

/// A picture that is read a row at a time, from the top, in memory that does not grow with its
/// height. The first picture of a file that has several, and its largest size. All may throw
/// Error(ErrorKind::file): "cannot read PATH: why".
class ImageReader {
  public:
    ImageReader(const std::string& path, const ImageLimits& limits)
        : ImageReader(path, path, limits) {}
    /// The file at `place`, which messages call `path`.
    ImageReader(const std::string& place, const std::string& path, const ImageLimits& limits);
    ~ImageReader();
    ImageReader(const ImageReader&) = delete;
    ImageReader& operator=(const ImageReader&) = delete;

    [[nodiscard]] const ImageHeader& header() const;
    /// The next row, interleaved: width times the number of channels. It stays until the next call.
    /// Precondition: fewer than `height` rows were asked for.
    [[nodiscard]] const float* next_row();

  private:
    struct File;
    std::unique_ptr<File> file_;
};

/// A picture read back: interleaved floats.
struct LoadedImage : ImageHeader {
    std::vector<float> values;

    [[nodiscard]] float at(std::size_t pixel, int channel) const {
        return values[pixel * channels.size() + static_cast<std::size_t>(channel)];
    }
};

/// Reads a whole picture, or its first channel and those named in `wanted`. Throws
/// Error(ErrorKind::file), also beyond `kept_image`.
[[nodiscard]] LoadedImage read_image(const std::string& path,
                                     const std::vector<std::string>& wanted = {});

/// A picture in linear red, green and blue, by rows from the top.
struct LinearPicture {
    int width = 0;
    int height = 0;
    std::vector<std::array<float, 3>> pixels;
};

/// The whole picture that `reader` has opened: integers are decoded from sRGB unless the file says
/// that they are linear, grey becomes three equal channels, further channels are left out. Throws
/// Error(ErrorKind::file).
[[nodiscard]] LinearPicture read_linear_picture(ImageReader& reader);

/// Linear of a value of the sRGB curve, 0..1.
[[nodiscard]] float linear_from_srgb(float srgb);

}  // namespace pxm::host
