#include "host/output/ply.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstring>

#include "host/output/image.hpp"
#include "host/scene/printable.hpp"

namespace pxm::host {

namespace {

static_assert(std::endian::native == std::endian::little, "the header says little endian");

constexpr std::size_t point_bytes = 3 * sizeof(float) + 3;
constexpr std::size_t buffer_bytes = std::size_t{1} << 20;

/// sRGB bytes of linear values in 4096 steps: a point a power function is too slow.
unsigned char srgb_byte(double linear) {
    static const std::array<unsigned char, 4097> table = [] {
        std::array<unsigned char, 4097> bytes{};
        for (std::size_t i = 0; i < bytes.size(); ++i) {
            bytes[i] = static_cast<unsigned char>(
                srgb_from_linear(static_cast<float>(i) / 4096.0F) * 255.0F + 0.5F);
        }
        return bytes;
    }();
    const double clamped = linear < 0 ? 0 : linear > 1 ? 1 : linear;
    return table[static_cast<std::size_t>(clamped * 4096 + 0.5)];
}

}  // namespace

PlyWriter::PlyWriter(CheckedFile& file, std::uint64_t count, const std::string& comment)
    : file_(file) {
    buffer_.reserve(buffer_bytes + point_bytes);
    const std::string header = fmt::format(
        "ply\nformat binary_little_endian 1.0\ncomment {}\nelement vertex {}\n"
        "property float x\nproperty float y\nproperty float z\n"
        "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n",
        printable_path(comment), count);
    file_.append(header.data(), header.size());
}

void PlyWriter::add(const glm::dvec3& place, const glm::dvec3& color) {
    const std::array<float, 3> xyz{static_cast<float>(place.x), static_cast<float>(place.y),
                                   static_cast<float>(place.z)};
    const std::array<unsigned char, 3> rgb{srgb_byte(color.r), srgb_byte(color.g),
                                           srgb_byte(color.b)};
    const std::size_t at = buffer_.size();
    buffer_.resize(at + point_bytes);
    std::memcpy(buffer_.data() + at, xyz.data(), sizeof xyz);
    std::memcpy(buffer_.data() + at + sizeof xyz, rgb.data(), sizeof rgb);
    if (buffer_.size() >= buffer_bytes) flush();
}

void PlyWriter::flush() {
    file_.append(buffer_.data(), buffer_.size());
    buffer_.clear();
}

void PlyWriter::finish() { flush(); }

}  // namespace pxm::host
