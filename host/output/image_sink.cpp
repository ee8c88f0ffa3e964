#define FMT_EXCEPTIONS 1  // OpenImageIO's headers would switch them off
#include "host/output/image_sink.hpp"

#include <OpenImageIO/imageio.h>

#include <memory>
#include <vector>

namespace pxm::host {

std::size_t ImageSink::read(void* data, std::size_t bytes) {
    const std::size_t got = file_.read_at(m_pos, data, bytes);
    m_pos += static_cast<std::int64_t>(got);
    return got;
}

std::size_t ImageSink::write(const void* data, std::size_t bytes) {
    const std::size_t written = pwrite(data, bytes, m_pos);
    m_pos += static_cast<std::int64_t>(written);
    return written;
}

std::size_t ImageSink::pread(void* data, std::size_t bytes, std::int64_t place) {
    return file_.read_at(place, data, bytes);
}

std::size_t ImageSink::pwrite(const void* data, std::size_t bytes, std::int64_t place) {
    return file_.write_at(place, data, bytes) ? bytes : 0;
}

std::size_t ImageSink::size() const { return static_cast<std::size_t>(file_.size()); }

std::string why_not_as_written(const std::string& path, int width, int height, const Digest& rows) {
    const std::string damaged = "what was written cannot be read back: the disk may be full";
    const auto input = OIIO::ImageInput::open(path);
    if (!input) return (void)OIIO::geterror(), damaged;
    const OIIO::ImageSpec& spec = input->spec();
    if (spec.width != width || spec.height != height || spec.nchannels < 3) return damaged;
    std::vector<unsigned char> row(3 * static_cast<std::size_t>(width));
    Digest found;
    for (int y = 0; y < height; ++y) {
        const int line = spec.y + y;
        if (!input->read_scanlines(0, 0, line, line + 1, 0, 0, 3, OIIO::TypeDesc::UINT8,
                                   row.data())) {
            return damaged;
        }
        found.add_all(std::span<const unsigned char>(row));
    }
    // HEIF keeps pictures only nearly: there it is enough that all of it can be decoded.
    const bool exact = std::string_view(input->format_name()) != "heif";
    return exact && found.value() != rows.value() ? damaged : "";
}

}  // namespace pxm::host
