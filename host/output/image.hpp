// Pictures as files that are written: PNG by the threads that render (host/output/png.hpp), EXR by
// OpenEXR, all others through OpenImageIO.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "host/engine/aov.hpp"
#include "host/engine/frame.hpp"
#include "host/files/picture_library.hpp"

namespace pxm::host {

/// Throws Error(ErrorKind::setting) unless this kind of file can be written and it can hold the
/// channels asked for (only EXR has room for any). Where OpenImageIO will be needed it begins to be
/// loaded: to be called from the program's first thread, before there are others.
void require_image_format(const std::string& path, const std::vector<Aov>& aovs);

/// Channels of an EXR that come from elsewhere than its frame.
struct ExtraChannels {
    std::vector<std::string> names;                      // as the file has them
    Metadata metadata;                                   // under these names
    std::function<void(long x, long y, float* to)> put;  // the values of a pixel of the image
};

/// Metadata that says how an EXR is written: the names of channels to be kept in 16 bits, with
/// commas between them (`color` and those of --aov), and the image that the window is a part of.
inline constexpr char half_metadata[] = "half";
/// The same of the image.
inline constexpr char whole_metadata[] = "image_size";
/// In `half`: R, G, B and A.
inline constexpr char half_color[] = "color";

/// A picture that is written while it is rendered, whole or not at all. EXR and HDR hold linear
/// floats; other formats hold 8 bits with the sRGB curve. An EXR has R, G, B and A, which is 1 as
/// the colour has the background in it, and the channels asked for. All may throw
/// Error(ErrorKind::file).
class ImageWriter {
  public:
    /// Begins the file; `window` is what will be appended, `metadata` is written into it; `extra`
    /// must outlive this.
    ImageWriter(const std::string& path, const CropWindow& window, const std::vector<Aov>& aovs,
                const Metadata& metadata, const ExtraChannels* extra = nullptr);
    ImageWriter(const ImageWriter&) = delete;
    ImageWriter& operator=(const ImageWriter&) = delete;
    ~ImageWriter();  // an unfinished picture is removed

    /// A part of the window. Any thread, and parts in any order; the file does not depend on it.
    void append(const Frame& part);
    /// Puts the picture into its place. Precondition: all of the window was appended.
    void finish();

    /// What is between the pixels and a kind of file.
    class Encoder;

  private:
    std::unique_ptr<Encoder> encoder_;
};

/// Writes a whole frame as a picture, as ImageWriter does.
void write_image(const std::string& path, const Frame& frame, const std::vector<Aov>& aovs,
                 const Metadata& metadata);

}  // namespace pxm::host
