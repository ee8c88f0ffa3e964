// Between the host's vectors and the kernels'.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <limits>

#include "dsp_kernels/ray.hpp"
#include "host/wide/packet/ray_packet.hpp"

namespace pxm::host::wide {

[[nodiscard]] inline std::array<float, 3> to_floats(const kernels::Vec3<double>& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}
inline constexpr double far_away = std::numeric_limits<double>::infinity();

inline glm::dvec3 to_glm(const kernels::Vec3<double>& v) { return {v.x, v.y, v.z}; }
inline kernels::Vec3<double> to_node(const glm::dvec3& v) { return {v.x, v.y, v.z}; }
inline kernels::Ray<double> to_node(const LoneRay& ray) {
    return {to_node(ray.origin), to_node(ray.direction), 0};
}

}  // namespace pxm::host::wide
