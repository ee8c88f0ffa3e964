// Pictures as files, through OpenImageIO. The only place that knows that library.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "host/render/frame.hpp"

namespace pxm::host {

/// Channels that --aov can add to an EXR.
enum class Aov { z, node, cycles, volumes, level, heap, alpha, object, word, normal };

/// The name on the command line and in the file; N has three channels N.x, N.y, N.z.
[[nodiscard]] const char* aov_name(Aov aov);
/// All of them, in the order of the documentation.
[[nodiscard]] const std::vector<Aov>& all_aovs();

/// Metadata as text: name, value.
using Metadata = std::vector<std::pair<std::string, std::string>>;

/// Throws Error(ExitCode::command_line) unless OpenImageIO can write this kind of file and it can
/// hold the channels asked for (only EXR has room for any).
void require_image_format(const std::string& path, const std::vector<Aov>& aovs);

/// A picture that is written as its rows come, whole or not at all. EXR and HDR hold linear floats;
/// other formats hold 8 bits with the sRGB curve. All may throw Error(ExitCode::file).
class ImageWriter {
  public:
    ImageWriter(const std::string& path, const PixelSize& size, const std::vector<Aov>& aovs,
                const Metadata& metadata);
    ImageWriter(const ImageWriter&) = delete;
    ImageWriter& operator=(const ImageWriter&) = delete;
    ~ImageWriter();  // an unfinished picture is removed

    /// The next rows from the top, as wide as the picture.
    void append(const Frame& rows);
    /// Puts the picture into its place. Precondition: all rows were appended.
    void finish();

  private:
    struct File;
    std::unique_ptr<File> file_;
};

/// Writes the crop window's pixels as a picture, as ImageWriter does.
void write_image(const std::string& path, const Frame& frame, const std::vector<Aov>& aovs,
                 const Metadata& metadata);

/// A picture read back: interleaved floats and the names of its channels.
struct LoadedImage {
    int width = 0;
    int height = 0;
    std::vector<std::string> channels;
    std::vector<float> values;
    Metadata metadata;
    bool srgb = false;  // the values go through the sRGB curve

    /// The index of a channel, or -1.
    [[nodiscard]] int channel(const std::string& name) const;
    [[nodiscard]] float at(std::size_t pixel, int channel) const {
        return values[pixel * channels.size() + static_cast<std::size_t>(channel)];
    }
    [[nodiscard]] const std::string* find(const std::string& name) const;
};

/// Throws Error(ExitCode::file).
[[nodiscard]] LoadedImage read_image(const std::string& path);

/// A picture in linear red, green and blue, by rows from the top.
struct LinearPicture {
    int width = 0;
    int height = 0;
    std::vector<std::array<float, 3>> pixels;
};

inline constexpr long picture_side_pixels = 16'384;  // of a texture: whole parts have 16 bits
inline constexpr long picture_pixels = 4096L * 4096;

/// Reads a picture of any kind: integers are decoded from sRGB unless the file says that they are
/// linear, grey becomes three equal channels, further channels are left out. Throws
/// Error(ExitCode::file), also for one larger than the limits above.
[[nodiscard]] LinearPicture read_linear_picture(const std::string& path);

/// The sRGB curve of a linear value, 0..1, and back.
[[nodiscard]] float srgb_from_linear(float linear);
[[nodiscard]] float linear_from_srgb(float srgb);

}  // namespace pxm::host
