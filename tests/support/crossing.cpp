#include "tests/support/crossing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

namespace pxm::test {

using namespace host;

namespace {

/// |o + t d - c|^2 = r^2; the discriminant by the distance of the line from the centre.
std::optional<Crossing> cross_sphere(const glm::dvec3& o, const glm::dvec3& d,
                                     const CompiledVolume& sphere) {
    const glm::dvec3 from_center = o - sphere.center;
    const glm::dvec3 lever = glm::cross(from_center, d);
    const double a = glm::dot(d, d);
    const double b = glm::dot(from_center, d);
    const double discriminant = sphere.radius * sphere.radius * a - glm::dot(lever, lever);
    if (discriminant < 0) return std::nullopt;
    Crossing result;
    result.entry = (-b - std::sqrt(discriminant)) / a;
    result.exit = (-b + std::sqrt(discriminant)) / a;
    result.entry_normal = from_center + result.entry * d;
    result.exit_normal = from_center + result.exit * d;
    return result;
}

/// What bodies with flat faces are the intersection of: normals as long as they come.
std::vector<HalfSpace> sides_of(const CompiledVolume& volume) {
    std::vector<HalfSpace> sides = volume.half_spaces;
    if (volume.kind == kernels::Volume::hull) return sides;
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 half{0.0};
        half[axis] = (volume.high[axis] - volume.low[axis]) / 2;
        if (volume.kind == kernels::Volume::oriented) half = volume.half[static_cast<size_t>(axis)];
        sides.push_back({half, glm::dot(half, volume.center + half)});
        sides.push_back({-half, -glm::dot(half, volume.center - half)});
    }
    return sides;
}

/// Side by side.
std::optional<Crossing> cross_sides(const glm::dvec3& o, const glm::dvec3& d,
                                    const std::vector<HalfSpace>& sides) {
    Crossing result;
    for (const HalfSpace& side : sides) {
        const double slope = glm::dot(side.normal, d);
        const double left = side.offset - glm::dot(side.normal, o);
        if (slope == 0) {
            if (left < 0) return std::nullopt;
            continue;
        }
        const double t = left / slope;
        if (slope < 0 && t > result.entry) {
            result.entry = t;
            result.entry_normal = side.normal;
        }
        if (slope > 0 && t < result.exit) {
            result.exit = t;
            result.exit_normal = side.normal;
        }
    }
    if (result.exit < result.entry) return std::nullopt;
    return result;
}

/// A point of a surface that a line goes through.
struct Hit {
    double t;
    glm::dvec3 normal;
};

/// The hits of a convex surface are the ends of the line's interval.
std::optional<Crossing> between(const std::vector<Hit>& hits) {
    if (hits.size() < 2) return std::nullopt;
    const auto [first, last] = std::ranges::minmax_element(hits, {}, &Hit::t);
    return Crossing{first->t, last->t, first->normal, last->normal};
}

/// A disc across the axis, at that height, facing up (1) or down (-1).
void add_disc(const glm::dvec3& o, const glm::dvec3& d, double height, double radius, double facing,
              std::vector<Hit>& hits) {
    if (d.y == 0) return;
    const double t = (height - o.y) / d.y;
    if (std::hypot(o.x + t * d.x, o.z + t * d.z) <= radius) hits.push_back({t, {0, facing, 0}});
}

/// Both solutions of a t^2 + 2 b t + c = 0, or the one if a is zero.
std::vector<double> solutions(double a, double b, double c) {
    if (a == 0) return b == 0 ? std::vector<double>{} : std::vector<double>{-c / (2 * b)};
    const double discriminant = b * b - a * c;
    if (discriminant < 0) return {};
    const double root = std::sqrt(discriminant);
    const double q = b < 0 ? root - b : -root - b;
    return q == 0 ? std::vector<double>{0} : std::vector<double>{q / a, c / q};
}

std::optional<Crossing> cross_cone(const glm::dvec3& from, const glm::dvec3& d,
                                   const CompiledVolume& cone) {
    const double r = cone.radius;
    const glm::dvec3 o = from - cone.center;
    std::vector<Hit> hits;
    add_disc(o, d, 0, r, -1, hits);
    const glm::dvec3 w{o.x, o.y - r, o.z};  // from the apex
    for (const double t :
         solutions(d.x * d.x + d.z * d.z - d.y * d.y, w.x * d.x + w.z * d.z - w.y * d.y,
                   w.x * w.x + w.z * w.z - w.y * w.y)) {
        const glm::dvec3 at = o + t * d;
        if (at.y >= 0 && at.y <= r) hits.push_back({t, {at.x, std::hypot(at.x, at.z), at.z}});
    }
    return between(hits);
}

std::optional<Crossing> cross_cylinder(const glm::dvec3& from, const glm::dvec3& d,
                                       const CompiledVolume& cylinder) {
    const double r = cylinder.radius;
    const glm::dvec3 o = from - cylinder.center;
    std::vector<Hit> hits;
    add_disc(o, d, r, r, 1, hits);
    add_disc(o, d, -r, r, -1, hits);
    for (const double t :
         solutions(d.x * d.x + d.z * d.z, o.x * d.x + o.z * d.z, o.x * o.x + o.z * o.z - r * r)) {
        const glm::dvec3 at = o + t * d;
        if (std::abs(at.y) <= r) hits.push_back({t, {at.x, 0, at.z}});
    }
    return between(hits);
}

}  // namespace

std::optional<Crossing> cross_volume(const glm::dvec3& o, const glm::dvec3& d,
                                     const CompiledVolume& volume) {
    switch (volume.kind) {
        case kernels::Volume::sphere:
            return cross_sphere(o, d, volume);
        case kernels::Volume::cone:
            return cross_cone(o, d, volume);
        case kernels::Volume::cylinder:
            return cross_cylinder(o, d, volume);
        default:
            return cross_sides(o, d, sides_of(volume));
    }
}

double depth_inside(const CompiledVolume& volume, const glm::dvec3& point) {
    const glm::dvec3 p = point - volume.center;
    const double r = volume.radius;
    const double across = std::hypot(p.x, p.z);
    switch (volume.kind) {
        case kernels::Volume::sphere:
            return r - glm::length(p);
        case kernels::Volume::cone:
            return std::min(p.y, (r - p.y - across) / std::sqrt(2.0));
        case kernels::Volume::cylinder:
            return std::min(r - std::abs(p.y), r - across);
        default:
            break;
    }
    double least = std::numeric_limits<double>::infinity();
    for (const HalfSpace& side : sides_of(volume)) {
        const double above = glm::dot(side.normal, point) - side.offset;
        least = std::min(least, -above / glm::length(side.normal));
    }
    return least;
}

}  // namespace pxm::test
