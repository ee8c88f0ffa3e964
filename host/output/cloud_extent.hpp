// How far the points of a cloud lie apart and from the origin, and which numbers that takes.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

namespace pxm::host {

/// The numbers of coordinates in a file.
enum class CoordinateNumber { single, double_ };

/// The box around points.
class CloudExtent {
  public:
    void add(const glm::dvec3& point);
    void add(const CloudExtent& other);
    /// The box's longest side.
    [[nodiscard]] double size() const;
    /// The largest coordinate's magnitude.
    [[nodiscard]] double farthest() const;
    /// Near the middle, to a power of two that is no larger than the box: what is taken off the
    /// coordinates leaves no more of them to round.
    [[nodiscard]] glm::dvec3 offset() const;
    /// The same box without the offset.
    [[nodiscard]] CloudExtent without(const glm::dvec3& offset) const;

  private:
    bool empty_ = true;
    glm::dvec3 low_{0.0};
    glm::dvec3 high_{0.0};
};

/// `twice` if floats would leave fewer than 2^18 steps across one of the objects or across them
/// all, or cannot hold the coordinates. What is a point up to rounding has no shape to keep.
[[nodiscard]] CoordinateNumber number_for(const std::vector<CloudExtent>& objects);

}  // namespace pxm::host
