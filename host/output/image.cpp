#include "host/output/image.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>

#include "host/error.hpp"
#include "host/output/encoder.hpp"

namespace pxm::host {

namespace {

/// Whether OpenImageIO has a writer of colour pictures for this extension. Its `null` and `term`
/// write no file, a zfile holds depths, and its IFF takes tiles alone.
bool is_picture_format(const std::string& path) {
    std::string error;
    const auto output = picture_library().create(path, error);
    if (!output) return false;
    const std::string format = output->format();
    return format != "null" && format != "term" && format != "zfile" && format != "iff";
}

/// What OpenImageIO is known to write: it need not be asked before the render.
bool is_known_format(const std::string& extension) {
    constexpr std::array known{"tif", "tiff", "jpg", "jpeg", "hdr"};
    return std::ranges::count(known, extension) > 0;
}

}  // namespace

std::string extension_of(const std::string& path) {
    const auto dot = path.rfind('.');
    const auto slash = path.rfind('/');
    if (dot == std::string::npos || (slash != std::string::npos && dot < slash)) return "";
    std::string extension = path.substr(dot + 1);
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

std::tm file_time() {
    const char* epoch = std::getenv("SOURCE_DATE_EPOCH");
    const std::time_t seconds = epoch ? static_cast<std::time_t>(std::atoll(epoch)) : 0;
    std::tm parts{};
    gmtime_r(&seconds, &parts);
    return parts;
}

void require_image_format(const std::string& path, const std::vector<Aov>& aovs) {
    const std::string extension = extension_of(path);
    if (is_known_format(extension)) {
        begin_loading_picture_library();
    } else if (extension != "png" && extension != "exr" &&
               (extension.empty() || !is_picture_format(path))) {
        throw Error(ErrorKind::setting, "cannot write " + path + ": unknown image extension \"" +
                                            extension + "\" (png, exr, tif, jpg, ...)");
    }
    if (!aovs.empty() && extension != "exr") {
        throw Error(ErrorKind::setting, "--aov needs an .exr output, not " + path);
    }
}

ImageWriter::ImageWriter(const std::string& path, const CropWindow& window,
                         const std::vector<Aov>& aovs, const Metadata& metadata,
                         const ExtraChannels* extra)
    : encoder_(extension_of(path) == "png"
                   ? make_png_encoder(path, window, metadata)
                   : make_library_encoder(path, window, aovs, metadata, extra)) {}

ImageWriter::~ImageWriter() = default;

void ImageWriter::append(const Frame& part) { encoder_->append(part); }

void ImageWriter::finish() { encoder_->finish(); }

void write_image(const std::string& path, const Frame& frame, const std::vector<Aov>& aovs,
                 const Metadata& metadata) {
    ImageWriter writer(path, frame.crop, aovs, metadata);
    writer.append(frame);
    writer.finish();
}

}  // namespace pxm::host
