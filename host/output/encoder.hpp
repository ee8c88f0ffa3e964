// The two ways of an ImageWriter.
#pragma once

#include <ctime>
#include <memory>
#include <string>

#include "host/output/image.hpp"

namespace pxm::host {

class ImageWriter::Encoder {
  public:
    virtual ~Encoder() = default;
    virtual void append(const Frame& part) = 0;
    virtual void finish() = 0;
};

/// Throws Error(ErrorKind::file).
[[nodiscard]] std::unique_ptr<ImageWriter::Encoder> make_png_encoder(const std::string& path,
                                                                     const CropWindow& window,
                                                                     const Metadata& metadata);
[[nodiscard]] std::unique_ptr<ImageWriter::Encoder> make_library_encoder(
    const std::string& path, const CropWindow& window, const std::vector<Aov>& aovs,
    const Metadata& metadata, const ExtraChannels* extra);

/// The extension in small letters, without the dot; empty if there is none.
[[nodiscard]] std::string extension_of(const std::string& path);

/// The time that a file tells of: SOURCE_DATE_EPOCH or a constant, so that equal renders are equal
/// files.
[[nodiscard]] std::tm file_time();

/// The metadata that is a text of a scene (host/files/carried_text.hpp).
inline constexpr char carried_metadata[] = "source";

inline constexpr char software[] = "pxm " PXM_VERSION;

}  // namespace pxm::host
