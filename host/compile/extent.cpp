#include "host/compile/extent.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "host/compiled/bounding_volume.hpp"
#include "host/math/lipschitz.hpp"

namespace pxm::host {

double Extent::support(const glm::dvec3& direction) const {
    const glm::dvec3 along{glm::dot(half[0], direction), glm::dot(half[1], direction),
                           glm::dot(half[2], direction)};
    return round ? glm::length(along) : std::abs(along.x) + std::abs(along.y) + std::abs(along.z);
}

double Extent::radius() const {
    if (round) return singular_values({half[0], half[1], half[2]}).values[0];
    double longest = 0;
    for (const double s : {-1.0, 1.0}) {
        for (const double t : {-1.0, 1.0}) {
            longest = std::max(longest, glm::length(half[0] + s * half[1] + t * half[2]));
        }
    }
    return longest;
}

double Extent::distance() const {
    double farthest = 0;  // of planes that part it from the eye
    const auto try_normal = [&](const glm::dvec3& normal) {
        const double length = glm::length(normal);
        if (!(length > 0)) return;
        const double gap = std::abs(glm::dot(center, normal)) - support(normal);
        farthest = std::max(farthest, gap / length);
    };
    try_normal(center / std::max(glm::length(center), 1e-300));
    for (const glm::dvec3& axis : singular_values({half[0], half[1], half[2]}).output) {
        try_normal(axis);
    }
    if (round) return farthest;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 a = half[i];
        const glm::dvec3 b = half[(i + 1) % 3];
        const double size = glm::length(a) * glm::length(b);
        if (size > 0) try_normal(glm::cross(a, b) / size);
    }
    return farthest;
}

glm::dvec3 middle(const CompiledVolume& volume) {
    return volume.kind == kernels::Volume::hull ? volume.center : ball_around(volume).center;
}

Extent extent(const CompiledVolume& volume, const glm::dmat3& linear, const glm::dvec3& center) {
    Extent result;
    result.center = center;
    glm::dmat3 half{volume.diameter / 2};
    switch (volume.kind) {
        case kernels::Volume::box: {
            const glm::dvec3 edge = (volume.high - volume.low) / 2.0;
            half = glm::dmat3{edge.x, 0, 0, 0, edge.y, 0, 0, 0, edge.z};
            result.round = false;
            break;
        }
        case kernels::Volume::oriented:
            half = {volume.half[0], volume.half[1], volume.half[2]};
            result.round = false;
            break;
        case kernels::Volume::hull:
            half = glm::dmat3{volume.diameter};  // its centre may be anywhere in it
            break;
        case kernels::Volume::sphere:
        case kernels::Volume::cone:
        case kernels::Volume::cylinder:
            break;
    }
    for (int i = 0; i < 3; ++i) result.half[static_cast<std::size_t>(i)] = linear * half[i];
    return result;
}

Frustum::Frustum(const View& view, const PixelSize& size) {
    const double half_height =
        view.half_width * static_cast<double>(size.rows) / static_cast<double>(size.columns);
    inward_ = {view.forward, view.forward * view.half_width - view.right,
               view.forward * view.half_width + view.right, view.forward * half_height - view.up,
               view.forward * half_height + view.up};
}

bool Frustum::misses(const Extent& extent, double bulge) const {
    return std::ranges::any_of(inward_, [&](const glm::dvec3& normal) {
        return glm::dot(extent.center, normal) < -bulge * extent.support(normal);
    });
}

}  // namespace pxm::host
