#include "host/compile/computed_volume.hpp"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "host/compiled/bounding_volume.hpp"
#include "host/fractal/bounds/polytope.hpp"

namespace pxm::host {

namespace {

constexpr double flat = 1.0 / 1024;    // of the diagonal
constexpr double thickness = 1.0 / 4;  // of the diagonal: a terminal cell's is p / 4

/// What flat edges of a box get added at either end. Where a ray crosses a volume without
/// thickness, its interval is a point, and rounding would part it from its parent's.
glm::dvec3 padding(const glm::dvec3& edges) {
    const double diagonal = glm::length(edges);
    glm::dvec3 result{0.0};
    for (int axis = 0; axis < 3; ++axis) {
        if (edges[axis] < flat * diagonal) result[axis] = (thickness * diagonal - edges[axis]) / 2;
    }
    return result;
}

/// The directions in which a set is flat, with what is to be added there on both sides.
std::array<glm::dvec3, 3> padding(const OrientedBox& box) {
    std::array<double, 3> lengths{};
    for (std::size_t i = 0; i < 3; ++i) lengths[i] = glm::length(box.half[i]);
    const glm::dvec3 more = padding(2.0 * glm::dvec3{lengths[0], lengths[1], lengths[2]});
    std::array<glm::dvec3, 3> result{};
    for (std::size_t i = 0; i < 3; ++i) {
        if (more[static_cast<int>(i)] > 0) {
            result[i] = box.half[i] / lengths[i] * more[static_cast<int>(i)];
        }
    }
    return result;
}

bool is_point(const OrientedBox& box) {
    for (const glm::dvec3& half : box.half) {
        if (!(glm::length(half) > 0)) return true;
    }
    return false;
}

}  // namespace

bool is_flat(const Box& bounds) { return padding(bounds.high - bounds.low) != glm::dvec3{0.0}; }

CompiledVolume VolumeComputer::sphere(std::size_t set) const {
    return sphere_volume(bounds_[set].ball.center, bounds_[set].ball.radius);
}

CompiledVolume VolumeComputer::box(std::size_t set) const {
    const Box& tight = bounds_[set].box;
    const glm::dvec3 margin = padding(tight.high - tight.low);
    return box_volume(tight.low - margin, tight.high + margin);
}

CompiledVolume VolumeComputer::oriented(std::size_t set) {
    OrientedBox tight = oriented_box(rifs_, known(), static_cast<int>(set));
    if (is_point(tight)) return sphere(set);
    const auto margin = padding(tight);
    for (std::size_t i = 0; i < 3; ++i) tight.half[i] += margin[i];
    return oriented_volume(tight);
}

CompiledVolume VolumeComputer::hull(std::size_t set) {
    const OrientedBox tight = oriented_box(rifs_, known(), static_cast<int>(set));
    if (is_point(tight)) return sphere(set);
    Polytope sides = polytope(rifs_, known(), static_cast<int>(set));
    for (const glm::dvec3& margin : padding(tight)) {
        for (HalfSpace& side : sides) side.offset += std::abs(glm::dot(side.normal, margin));
    }
    return hull_volume(sides, bounds_[set].ball.center);
}

CompiledVolume VolumeComputer::make(kernels::Volume kind, std::size_t set) {
    if (kind == kernels::Volume::sphere) return sphere(set);
    if (kind == kernels::Volume::box) return box(set);
    return kind == kernels::Volume::hull ? hull(set) : oriented(set);
}

const Approximation& VolumeComputer::known() {
    if (!known_) known_ = approximation(rifs_, bounds_);
    return *known_;
}

}  // namespace pxm::host
