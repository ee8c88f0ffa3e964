// Point clouds as binary PLY, written as a stream: any number of points in constant memory.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "host/files/checked_file.hpp"
#include "host/output/cloud_extent.hpp"

namespace pxm::host {

/// Writes `count` points: x y z as floats of 32 bits or of 64, red green blue as bytes (sRGB),
/// little endian.
class PlyWriter {
  public:
    /// `file` must outlive it; of the comment one line is taken, as it can be shown. Throws
    /// Error(ErrorKind::file), as do the other functions.
    PlyWriter(CheckedFile& file, std::uint64_t count, const std::string& comment,
              CoordinateNumber number);

    /// `color` is linear, 0..1.
    void add(const glm::dvec3& place, const glm::dvec3& color);
    /// Writes what is left. Precondition: `count` points were added.
    void finish();

  private:
    void flush();

    CheckedFile& file_;
    CoordinateNumber number_;
    std::vector<char> buffer_;
};

}  // namespace pxm::host
