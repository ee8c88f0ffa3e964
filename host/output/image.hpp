// Pictures as files that are written, through OpenImageIO.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "host/engine/aov.hpp"
#include "host/engine/frame.hpp"
#include "host/files/image_reader.hpp"

namespace pxm::host {

/// Throws Error(ErrorKind::setting) unless OpenImageIO can write this kind of file and it can
/// hold the channels asked for (only EXR has room for any).
void require_image_format(const std::string& path, const std::vector<Aov>& aovs);

/// A picture that is written as its rows come, whole or not at all. EXR and HDR hold linear floats;
/// other formats hold 8 bits with the sRGB curve. An EXR has R, G, B and A, which is 1 as the
/// colour has the background in it, and the channels asked for. All may throw
/// Error(ErrorKind::file).
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

/// The sRGB curve of a linear value, 0..1.
[[nodiscard]] float srgb_from_linear(float linear);

}  // namespace pxm::host
