#include "host/compiled/bounding_volume.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace pxm::host {

CompiledVolume sphere_volume(const glm::dvec3& center, double radius) {
    CompiledVolume volume;
    volume.kind = kernels::Volume::sphere;
    volume.center = center;
    volume.radius = radius;
    volume.low = center - radius;
    volume.high = center + radius;
    volume.diameter = 2 * radius;
    return volume;
}

CompiledVolume box_volume(const glm::dvec3& low, const glm::dvec3& high) {
    CompiledVolume volume;
    volume.kind = kernels::Volume::box;
    volume.center = (low + high) / 2.0;
    volume.low = low;
    volume.high = high;
    volume.diameter = glm::length(high - low);
    return volume;
}

CompiledVolume oriented_volume(const OrientedBox& box) {
    CompiledVolume volume;
    volume.kind = kernels::Volume::oriented;
    volume.center = box.center;
    volume.half = box.half;
    volume.diameter = 2 * glm::length(box.half[0] + box.half[1] + box.half[2]);
    return volume;
}

CompiledVolume hull_volume(const Polytope& polytope, const glm::dvec3& center) {
    CompiledVolume volume;
    volume.kind = kernels::Volume::hull;
    volume.center = center;
    volume.half_spaces = polytope;
    volume.diameter = diameter(polytope);
    return volume;
}

CompiledVolume cone_volume() {
    CompiledVolume volume;
    volume.kind = kernels::Volume::cone;
    volume.radius = 1;
    volume.diameter = 2;  // across the base: the mantle is sqrt(2) long
    return volume;
}

CompiledVolume cylinder_volume() {
    CompiledVolume volume;
    volume.kind = kernels::Volume::cylinder;
    volume.radius = 1;
    volume.diameter = 2 * std::numbers::sqrt2;
    return volume;
}

CompiledVolume in_frame(const CompiledVolume& volume, const glm::dvec3& origin, double scale) {
    CompiledVolume result = volume;
    result.center = (volume.center - origin) / scale;
    result.low = (volume.low - origin) / scale;
    result.high = (volume.high - origin) / scale;
    result.radius = volume.radius / scale;
    result.diameter = volume.diameter / scale;
    for (glm::dvec3& half : result.half) half /= scale;
    for (HalfSpace& side : result.half_spaces) {
        side.offset = (side.offset - glm::dot(side.normal, origin)) / scale;
    }
    return result;
}

Ball ball_around(const CompiledVolume& volume) {
    // The ball about a cone's base disc reaches its apex too.
    if (volume.kind == kernels::Volume::cone) return {volume.center, volume.radius};
    return {volume.center, volume.diameter / 2};
}

}  // namespace pxm::host
