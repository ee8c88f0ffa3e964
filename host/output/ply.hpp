// Point clouds as binary PLY, made in pieces: any number of points in constant memory.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>

#include "host/output/cloud_extent.hpp"

namespace pxm::host {

/// What a file of `count` points begins with: x y z as floats of 32 bits or of 64, red green blue
/// as bytes (sRGB), little endian. Of the comment one line is taken, as it can be shown. An offset
/// that is not zero stands in a comment of its own: what was taken off the coordinates.
[[nodiscard]] std::string ply_header(std::uint64_t count, const std::string& comment,
                                     CoordinateNumber number,
                                     const glm::dvec3& offset = glm::dvec3(0.0));

/// Points as the bytes that follow the header.
class PlyPoints {
  public:
    explicit PlyPoints(CoordinateNumber number) : number_(number) {}

    /// `color` is linear, 0..1.
    void add(const glm::dvec3& place, const glm::dvec3& color);
    [[nodiscard]] const std::string& bytes() const { return bytes_; }

  private:
    CoordinateNumber number_;
    std::string bytes_;
};

}  // namespace pxm::host
