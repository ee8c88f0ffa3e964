#include "host/output/ply.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstring>

#include "host/error.hpp"
#include "host/output/image.hpp"

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

PlyWriter::PlyWriter(const std::string& path, std::uint64_t count, const std::string& comment)
    : path_(path), file_(path, std::ios::binary) {
    buffer_.reserve(buffer_bytes + point_bytes);
    file_ << fmt::format(
        "ply\nformat binary_little_endian 1.0\ncomment {}\nelement vertex {}\n"
        "property float x\nproperty float y\nproperty float z\n"
        "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n",
        comment, count);
    if (!file_) throw Error(ExitCode::file, fmt::format("cannot write {}", path));
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
    file_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    buffer_.clear();
    if (!file_)
        throw Error(ExitCode::file, fmt::format("cannot write {}: the disk may be full", path_));
}

void PlyWriter::finish() {
    flush();
    file_.close();
    if (!file_)
        throw Error(ExitCode::file, fmt::format("cannot write {}: the disk may be full", path_));
}

}  // namespace pxm::host
