#include "host/output/ply.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstring>

#include "host/output/image.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace {

static_assert(std::endian::native == std::endian::little, "the header says little endian");

constexpr std::size_t longest_point_bytes = 3 * sizeof(double) + 3;
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

template <class Value, std::size_t count>
void append(std::vector<char>& buffer, const std::array<Value, count>& values) {
    const std::size_t at = buffer.size();
    buffer.resize(at + sizeof values);
    std::memcpy(buffer.data() + at, values.data(), sizeof values);
}

}  // namespace

PlyWriter::PlyWriter(CheckedFile& file, std::uint64_t count, const std::string& comment,
                     CoordinateNumber number)
    : file_(file), number_(number) {
    buffer_.reserve(buffer_bytes + longest_point_bytes);
    const std::string header = fmt::format(
        "ply\nformat binary_little_endian 1.0\ncomment {}\nelement vertex {}\n"
        "property {number} x\nproperty {number} y\nproperty {number} z\n"
        "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n",
        printable_path(comment), count,
        fmt::arg("number", number == CoordinateNumber::single ? "float" : "double"));
    file_.append(header.data(), header.size());
}

void PlyWriter::add(const glm::dvec3& place, const glm::dvec3& color) {
    if (number_ == CoordinateNumber::single) {
        append(buffer_, std::array{static_cast<float>(place.x), static_cast<float>(place.y),
                                   static_cast<float>(place.z)});
    } else {
        append(buffer_, std::array{place.x, place.y, place.z});
    }
    append(buffer_, std::array{srgb_byte(color.r), srgb_byte(color.g), srgb_byte(color.b)});
    if (buffer_.size() >= buffer_bytes) flush();
}

void PlyWriter::flush() {
    file_.append(buffer_.data(), buffer_.size());
    buffer_.clear();
}

void PlyWriter::finish() { flush(); }

}  // namespace pxm::host
