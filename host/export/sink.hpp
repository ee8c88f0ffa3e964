// Bytes on their way to a file, collected to pieces of a size that files like.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>

#include "host/files/checked_file.hpp"
#include "host/output/cloud_extent.hpp"

namespace pxm::host {

static_assert(std::endian::native == std::endian::little, "the files say little endian");

class Sink {
  public:
    explicit Sink(CheckedFile& file) : file_(file) { bytes_.reserve(piece + reserve); }

    /// Where fmt::format_to may append; settle() afterwards.
    [[nodiscard]] std::string& text() { return bytes_; }
    void settle() {
        if (bytes_.size() >= piece) flush();
    }
    template <class Value>
    void put(Value value) {
        bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    void put_floats(const glm::dvec3& v) {
        put(static_cast<float>(v.x));
        put(static_cast<float>(v.y));
        put(static_cast<float>(v.z));
    }
    void put_point(const glm::dvec3& v, CoordinateNumber number) {
        if (number == CoordinateNumber::single) return put_floats(v);
        put(v.x);
        put(v.y);
        put(v.z);
    }
    /// Fills up to a multiple of four of the bytes so far.
    void align(char filler) {
        while ((written_ + bytes_.size()) % 4 != 0) bytes_ += filler;
    }
    void flush() {
        file_.append(bytes_.data(), bytes_.size());
        written_ += bytes_.size();
        bytes_.clear();
    }

  private:
    static constexpr std::size_t piece = std::size_t{1} << 20U;
    static constexpr std::size_t reserve = std::size_t{1} << 16U;
    CheckedFile& file_;
    std::string bytes_;
    std::uint64_t written_ = 0;
};

}  // namespace pxm::host
