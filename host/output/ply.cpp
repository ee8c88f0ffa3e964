#include "host/output/ply.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>

#include "host/output/pixel_values.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace {

static_assert(std::endian::native == std::endian::little, "the header says little endian");

template <class Value, std::size_t count>
void append(std::string& bytes, const std::array<Value, count>& values) {
    bytes.append(reinterpret_cast<const char*>(values.data()), sizeof values);
}

}  // namespace

std::string ply_header(std::uint64_t count, const std::string& comment, CoordinateNumber number,
                       const glm::dvec3& offset) {
    const bool moved = offset.x != 0 || offset.y != 0 || offset.z != 0;
    return fmt::format(
        "ply\nformat binary_little_endian 1.0\ncomment {}\n{}element vertex {}\n"
        "property {number} x\nproperty {number} y\nproperty {number} z\n"
        "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n",
        printable_path(comment),
        moved ? fmt::format("comment offset {} {} {}\n", offset.x, offset.y, offset.z) : "", count,
        fmt::arg("number", number == CoordinateNumber::single ? "float" : "double"));
}

void PlyPoints::add(const glm::dvec3& place, const glm::dvec3& color) {
    if (number_ == CoordinateNumber::single) {
        append(bytes_, std::array{static_cast<float>(place.x), static_cast<float>(place.y),
                                  static_cast<float>(place.z)});
    } else {
        append(bytes_, std::array{place.x, place.y, place.z});
    }
    const auto byte = [](double linear) { return srgb_byte(static_cast<float>(linear)); };
    append(bytes_, std::array{byte(color.r), byte(color.g), byte(color.b)});
}

}  // namespace pxm::host
