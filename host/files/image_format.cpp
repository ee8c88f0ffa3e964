#include "host/files/image_format.hpp"

namespace pxm::host {

namespace {

using namespace std::string_view_literals;

struct Signature {
    std::string_view bytes;
    std::size_t offset;
    std::string_view name;
    std::optional<ImageFormat> format;
};

// Longer signatures first. Those without a format are here so that they can be told by name.
constexpr Signature signatures[] = {
    {"\x89PNG\r\n\x1a\n"sv, 0, "PNG", ImageFormat::png},
    {"\xff\xd8\xff"sv, 0, "JPEG", ImageFormat::jpeg},
    {"\x76\x2f\x31\x01"sv, 0, "OpenEXR", ImageFormat::openexr},
    {"II*\0"sv, 0, "TIFF", ImageFormat::tiff},
    {"MM\0*"sv, 0, "TIFF", ImageFormat::tiff},
    {"II+\0"sv, 0, "TIFF", ImageFormat::tiff},  // BigTIFF
    {"MM\0+"sv, 0, "TIFF", ImageFormat::tiff},
    {"GIF8"sv, 0, "GIF", {}},
    {"WEBP"sv, 8, "WebP", {}},
    {"DDS "sv, 0, "DDS", {}},
    {"#?RADIANCE"sv, 0, "Radiance HDR", {}},
    {"#?RGBE"sv, 0, "Radiance HDR", {}},
    {"8BPS"sv, 0, "Photoshop", {}},
    {"\0\0\0\x0cjP  "sv, 0, "JPEG 2000", {}},
    {"\xff\x4f\xff\x51"sv, 0, "JPEG 2000", {}},
    {"ftyp"sv, 4, "HEIF, AVIF or video", {}},
    {"SIMPLE  ="sv, 0, "FITS", {}},
    {"SDPX"sv, 0, "DPX", {}},
    {"XPDS"sv, 0, "DPX", {}},
    {"\0\0\1\0"sv, 0, "Windows icon", {}},
    {"\x01\xda"sv, 0, "SGI", {}},
    {"BM"sv, 0, "BMP", {}},
};

/// P1 to P6, PF and Pf, and white space or a comment after it.
bool is_pnm(std::string_view head) {
    return head.size() > 2 && head[0] == 'P' &&
           "123456Ff"sv.find(head[1]) != std::string_view::npos &&
           " \t\r\n#"sv.find(head[2]) != std::string_view::npos;
}

}  // namespace

FoundFormat found_format(std::string_view head) {
    for (const Signature& s : signatures) {
        if (head.size() >= s.offset && head.substr(s.offset).starts_with(s.bytes))
            return {s.name, s.format};
    }
    if (is_pnm(head)) return {"PNM", ImageFormat::pnm};
    return {};
}

const char* reader_name(ImageFormat format) {
    switch (format) {
        case ImageFormat::png:
            return "png";
        case ImageFormat::jpeg:
            return "jpeg";
        case ImageFormat::openexr:
            return "openexr";
        case ImageFormat::tiff:
            return "tiff";
        case ImageFormat::pnm:
            return "pnm";
    }
    return "";
}

}  // namespace pxm::host
