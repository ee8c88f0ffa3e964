#include "host/studio/picture.hpp"

#include <sys/mman.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "host/error.hpp"
#include "host/files/checked_file.hpp"
#include "host/output/encoder.hpp"
#include "host/output/pixel_values.hpp"
#include "host/output/png.hpp"
#include "host/output/row_bands.hpp"

namespace pxm::host {

namespace {

void put_number(std::string& bytes, std::uint64_t number) {
    const std::uint64_t most = std::numeric_limits<std::uint32_t>::max();
    const std::uint64_t kept = std::min(number, most);
    for (int shift = 0; shift < 32; shift += 8)
        bytes += static_cast<char>(static_cast<unsigned char>(kept >> shift));
}

std::vector<unsigned char> rgb_of(const Frame& frame) {
    std::vector<unsigned char> rgb(frame.pixels.size() * 3);
    put_srgb_bytes(frame.pixels, rgb.data());
    return rgb;
}

}  // namespace

RenderResult render_asked(const AskedPicture& asked, int threads, std::atomic<bool>& stop) {
    if (stop) {
        RenderResult result;
        result.stopped = true;
        return result;
    }
    std::atomic<bool> late = false;
    const auto begin = std::chrono::steady_clock::now();
    RunControl control;
    control.stop = &stop;
    control.progress = [&](double) {
        const auto passed = std::chrono::steady_clock::now() - begin;
        if (std::chrono::duration<double>(passed).count() <= asked_seconds) return;
        late = true;
        stop = true;
    };
    RenderResult result = render(request_of(asked, threads), control);
    if (late)
        throw Error(ErrorKind::failed,
                    "the picture takes longer than the studio waits; pxm render has no limit");
    return result;
}

std::string picture_bytes(const std::string& head, const RenderResult& result) {
    const Frame& frame = result.frame;
    const std::vector<unsigned char> rgb = rgb_of(frame);
    std::string bytes;
    bytes.reserve(4 + head.size() + frame.pixels.size() * 8);
    put_number(bytes, head.size());
    bytes += head;
    const std::size_t begin = bytes.size();
    bytes.resize(begin + frame.pixels.size() * 4, '\xFF');
    for (std::size_t i = 0; i < frame.pixels.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            bytes[begin + 4 * i + c] = static_cast<char>(rgb[3 * i + c]);
    if (result.statistics.machine)
        for (const PixelRecord& pixel : frame.pixels) put_number(bytes, pixel.cycles);
    return bytes;
}

std::string png_bytes(const Frame& frame) {
    const int descriptor = memfd_create("picture", MFD_CLOEXEC);
    if (descriptor < 0) throw Error(ErrorKind::failed, "no memory for the picture");
    CheckedFile file(descriptor, "picture", Places::any);
    PngFile png(file, static_cast<std::uint32_t>(frame.columns()),
                static_cast<std::uint32_t>(frame.rows()), software, file_time());
    const std::vector<unsigned char> rgb = rgb_of(frame);
    const std::size_t row_bytes = static_cast<std::size_t>(frame.columns()) * 3;
    const std::size_t segment = static_cast<std::size_t>(band_rows) * row_bytes;
    for (std::size_t at = 0; at < rgb.size(); at += segment)
        png.append(deflate_rows(std::span(rgb).subspan(at, std::min(segment, rgb.size() - at)),
                                row_bytes));
    png.finish();
    std::string bytes(static_cast<std::size_t>(file.size()), '\0');
    if (file.read_at(0, bytes.data(), bytes.size()) != bytes.size())
        throw Error(ErrorKind::failed, "the picture cannot be read back");
    return bytes;
}

}  // namespace pxm::host
