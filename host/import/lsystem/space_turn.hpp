// Directions of a turtle in space: what turns its own frame, forward, left and up, as a unit
// quaternion of 300 digits.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "host/import/lsystem/long_number.hpp"

namespace pxm::host {

struct LongVec3 {
    LongReal forward{0};
    LongReal left{0};
    LongReal up{0};
};
[[nodiscard]] LongVec3 operator+(const LongVec3& a, const LongVec3& b);
[[nodiscard]] LongVec3 operator-(const LongVec3& a, const LongVec3& b);
[[nodiscard]] LongVec3 operator*(const LongReal& a, const LongVec3& b);
/// The largest coordinate's magnitude.
[[nodiscard]] LongReal size(const LongVec3& v);
[[nodiscard]] glm::dvec3 to_double(const LongVec3& v);

/// A turn about an axis of the turtle.
class SpaceTurn {
  public:
    SpaceTurn() = default;  // none
    /// About its own axis of that number: 0 forward, 1 left, 2 up; counterclockwise as seen from
    /// the axis's end.
    SpaceTurn(int axis, const LongReal& degrees);

    /// This turn, and then the other one about the turned axes.
    [[nodiscard]] SpaceTurn then(const SpaceTurn& other) const;
    [[nodiscard]] SpaceTurn inverse() const;
    [[nodiscard]] LongVec3 of(const LongVec3& v) const;
    /// Up to what is far below any angle that is written.
    [[nodiscard]] bool is_same(const SpaceTurn& other) const;
    [[nodiscard]] glm::dmat3 matrix() const;

  private:
    LongReal real_{1};
    LongVec3 axis_;
};

}  // namespace pxm::host
