// Where a line crosses a bounding volume, computed in double from the definition of each kind and
// by other ways than the kernels': what they are judged by.
#pragma once

#include <glm/vec3.hpp>
#include <limits>
#include <optional>

#include "host/compiled/compiled_scene.hpp"

namespace pxm::test {

/// Where a line is inside a volume, and the volume's outward normals at both ends.
struct Crossing {
    double entry = -std::numeric_limits<double>::infinity();
    double exit = std::numeric_limits<double>::infinity();
    glm::dvec3 entry_normal{0.0};
    glm::dvec3 exit_normal{0.0};
};

/// The line o + t d in the volume's coordinates; nothing if it does not meet the volume.
[[nodiscard]] std::optional<Crossing> cross_volume(const glm::dvec3& o, const glm::dvec3& d,
                                                   const host::CompiledVolume& volume);

/// How deep a point lies inside the volume; negative outside. Exact in sign, and not steeper than a
/// distance.
[[nodiscard]] double depth_inside(const host::CompiledVolume& volume, const glm::dvec3& point);

}  // namespace pxm::test
