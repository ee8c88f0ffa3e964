#include "host/output/ply.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstring>

#include "host/output/pixel_values.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace {

static_assert(std::endian::native == std::endian::little, "the header says little endian");

constexpr std::size_t longest_point_bytes = 3 * sizeof(double) + 3;
constexpr std::size_t buffer_bytes = std::size_t{1} << 20;

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
    const auto byte = [](double linear) { return srgb_byte(static_cast<float>(linear)); };
    append(buffer_, std::array{byte(color.r), byte(color.g), byte(color.b)});
    if (buffer_.size() >= buffer_bytes) flush();
}

void PlyWriter::flush() {
    file_.append(buffer_.data(), buffer_.size());
    buffer_.clear();
}

void PlyWriter::finish() { flush(); }

}  // namespace pxm::host
