// PNG, the format of pictures unless another is named, made by the threads that render: segments of
// rows are deflated independently of each other and put behind one another. No library does that;
// the deflating is zlib's. All rows use the filter Sub, which needs no row above, and zlib's
// fastest level: a picture is a few per cent larger than by the filters and the level that
// libraries take, and is there several times sooner.
#pragma once

#include <cstdint>
#include <ctime>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/files/checked_file.hpp"

namespace pxm::host {

/// Rows of one picture, deflated, and the checksum of what they were.
struct PngSegment {
    std::vector<unsigned char> deflated;
    std::uint32_t checksum = 0;  // Adler-32 of the rows with their filters
    std::uint64_t bytes = 0;     // of the same
};

/// `rows` is a whole number of rows of `row_bytes`, three bytes a pixel. Any thread. Throws
/// std::bad_alloc.
[[nodiscard]] PngSegment deflate_rows(std::span<const unsigned char> rows, std::size_t row_bytes);

/// A PNG of three channels of 8 bits in sRGB, whose segments come from the top to the bottom.
class PngFile {
  public:
    /// Writes the head; `file` must outlive this. Throws Error(ErrorKind::file), as all here.
    PngFile(CheckedFile& file, std::uint32_t columns, std::uint32_t rows,
            const std::string& software, const std::tm& time);
    /// A chunk iTXt, before the first segment.
    void text(std::string_view content);
    void append(const PngSegment& segment);
    /// After the last segment.
    void finish();

  private:
    void chunk(const char (&type)[5], std::span<const unsigned char> data);

    CheckedFile& file_;
    std::uint32_t checksum_;
    bool begun_ = false;
};

}  // namespace pxm::host
