// `pxm points --precision`, `--offset`: the coordinates of a cloud's file.
#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "host/output/cloud_extent.hpp"

namespace pxm::host {

struct Coordinates {
    CoordinateNumber number = CoordinateNumber::single;
    glm::dvec3 offset{0.0};  // is taken off
};

/// Throws Error(ErrorKind::setting) unless both can be read: float, double or auto; x,y,z, auto or
/// nothing.
void require_coordinates(const std::string& precision, const std::string& offset);

/// Of objects with these boxes. Precondition: require_coordinates() takes the texts.
[[nodiscard]] Coordinates coordinates_of(std::vector<CloudExtent> extents,
                                         const std::string& precision, const std::string& offset);

}  // namespace pxm::host
