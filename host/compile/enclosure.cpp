#include "host/compile/enclosure.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace pxm::host {

namespace {

constexpr double flat = 0x1p-10;  // a ball nearer than that share of its radius is a half-space

CompiledVolume hull_of(std::vector<HalfSpace> half_spaces) {
    CompiledVolume volume;
    volume.kind = kernels::Volume::hull;
    volume.half_spaces = std::move(half_spaces);
    return volume;
}

/// The points x about the eye with normal . (x + eye - through) <= offset.
HalfSpace half_space(const glm::dvec3& normal, double offset, const glm::dvec3& through,
                     const PreciseVec3& eye) {
    const PreciseVec3 from_eye = subtract(precise(through), eye);
    const double length = glm::length(normal);
    return {normal / length, rounded(Precise(offset) + dot(precise(normal), from_eye)) / length};
}

CompiledVolume ball_about(const CompiledVolume& ball, const PreciseVec3& eye) {
    const PreciseVec3 to_eye = subtract(eye, precise(ball.center));
    const Precise radius{ball.radius};
    const double beyond = rounded(dot(to_eye, to_eye) - radius * radius);
    const double distance = glm::length(rounded(to_eye));
    const double gap = beyond / (distance + ball.radius);  // between eye and ball
    if (gap > 0 && gap < flat * ball.radius) return hull_of({{rounded(to_eye) / distance, -gap}});
    CompiledVolume result = ball;
    result.center = -rounded(to_eye);
    return result;
}

/// The volume in coordinates that have the eye, a place in its own, as their origin.
CompiledVolume volume_about(const CompiledVolume& volume, const PreciseVec3& eye) {
    std::vector<HalfSpace> half_spaces;
    switch (volume.kind) {
        case kernels::Volume::sphere:
            return ball_about(volume, eye);
        case kernels::Volume::box: {
            CompiledVolume box = volume;
            box.center = glm::dvec3{0};
            box.low = rounded(subtract(precise(volume.low), eye));
            box.high = rounded(subtract(precise(volume.high), eye));
            return box;
        }
        case kernels::Volume::oriented:
            for (const glm::dvec3& half : volume.half) {
                const glm::dvec3 axis = half / glm::dot(half, half);
                half_spaces.push_back(half_space(axis, 1, volume.center, eye));
                half_spaces.push_back(half_space(-axis, 1, volume.center, eye));
            }
            break;
        case kernels::Volume::hull:
            for (const HalfSpace& side : volume.half_spaces) {
                half_spaces.push_back(half_space(side.normal, side.offset, glm::dvec3{0}, eye));
            }
            break;
        case kernels::Volume::cone:
        case kernels::Volume::cylinder:
            break;
    }
    return hull_of(std::move(half_spaces));
}

/// Whether the origin is outside of it.
bool is_outside(const CompiledVolume& volume) {
    if (volume.kind == kernels::Volume::sphere) {
        return glm::length(volume.center) > volume.radius;
    }
    if (volume.kind == kernels::Volume::box) {
        return glm::any(glm::greaterThan(volume.low, glm::dvec3{0})) ||
               glm::any(glm::lessThan(volume.high, glm::dvec3{0}));
    }
    return std::ranges::any_of(volume.half_spaces,
                               [](const HalfSpace& side) { return side.offset < 0; });
}

}  // namespace

std::optional<CompiledEnclosure> enclosure(const PreciseAffine& place, const CompiledVolume& volume,
                                           double diameter, double unit, Rays rays) {
    CompiledEnclosure result;
    result.volume = volume_about(volume, origin_of(place));
    if (rays == Rays::from_the_eye && !is_outside(result.volume)) return std::nullopt;
    result.volume.diameter = diameter / unit;
    result.inverse.linear = glm::inverse(rounded_linear(place)) * unit;
    return result;
}

CompiledEnclosure silent_enclosure(double diameter, double unit) {
    CompiledEnclosure result;
    result.volume = hull_of({});
    result.volume.diameter = diameter / unit;
    return result;
}

}  // namespace pxm::host
