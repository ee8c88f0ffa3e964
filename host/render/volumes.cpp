#include "host/render/volumes.hpp"

#include <fmt/format.h>

#include <glm/geometric.hpp>
#include <numbers>
#include <optional>

namespace pxm::host {

namespace {

CompiledVolume sphere(const glm::dvec3& center, double radius) {
    CompiledVolume volume;
    volume.kind = kernels::Volume::sphere;
    volume.center = center;
    volume.radius = radius;
    volume.low = center - radius;
    volume.high = center + radius;
    volume.diameter = 2 * radius;
    return volume;
}

CompiledVolume box(const glm::dvec3& low, const glm::dvec3& high) {
    CompiledVolume volume;
    volume.kind = kernels::Volume::box;
    volume.center = (low + high) / 2.0;
    volume.low = low;
    volume.high = high;
    volume.diameter = glm::length(high - low);
    return volume;
}

/// Whether a box has no thickness to speak of along an axis.
bool flat_along(const Box& bounds, int axis) {
    constexpr double flat = 1.0 / 1024;  // of the diagonal
    return bounds.high[axis] - bounds.low[axis] < flat * glm::length(bounds.high - bounds.low);
}

/// A computed box. A flat attractor's box is given some thickness: where a ray crosses a box that
/// has none, its interval is a point, and rounding would part it from its parent's.
CompiledVolume computed_box(const Box& bounds) {
    constexpr double thickness = 1.0 / 4;  // of the diagonal: a terminal cell's is p / 4
    const glm::dvec3 size = bounds.high - bounds.low;
    glm::dvec3 margin{0.0};
    for (int axis = 0; axis < 3; ++axis) {
        if (!flat_along(bounds, axis)) continue;
        margin[axis] = (thickness * glm::length(size) - size[axis]) / 2;
    }
    return box(bounds.low - margin, bounds.high + margin);
}

/// The mean area of a volume's shadow: what a ray in a random direction has to hit (Cauchy: a
/// quarter of the surface of a convex body).
double mean_shadow(const Ball& ball) { return std::numbers::pi * ball.radius * ball.radius; }
double mean_shadow(const Box& volume) {
    const glm::dvec3 e = volume.high - volume.low;
    return (e.x * e.y + e.y * e.z + e.z * e.x) / 2;
}

VolumeKind computed_kind(VolumeKind kind, const Bounds& outermost) {
    if (kind == VolumeKind::sphere || kind == VolumeKind::box) return kind;
    // Spheres stay a pixel thick down to the last cell: curves and sheets edge on are not missed.
    for (int axis = 0; axis < 3; ++axis) {
        if (flat_along(outermost.box, axis)) return VolumeKind::sphere;
    }
    return mean_shadow(outermost.ball) <= mean_shadow(outermost.box) ? VolumeKind::sphere
                                                                     : VolumeKind::box;
}

/// The declared volume if it can be used; else nothing, with a warning that says why.
std::optional<CompiledVolume> declared_volume(const ObjectBlock& object, const Rifs& rifs,
                                              const std::vector<Bounds>& bounds,
                                              Diagnostics& diagnostics) {
    const auto replaced = [&](const char* what, double by) {
        diagnostics.warning(
            object.volume_position,
            fmt::format("the {} of object \"{}\" does not contain the attractor (short by {:.3g}): "
                        "a computed volume is used instead",
                        what, object.name, by));
    };
    if (const auto* ball = std::get_if<SphereVolume>(&*object.volume)) {
        const double by = short_by(rifs, bounds, rifs.start, *ball);
        if (by <= 0) return sphere(ball->center, ball->radius);
        replaced("sphere", by);
    } else if (const auto* corners = std::get_if<BoxVolume>(&*object.volume)) {
        const double by = short_by(rifs, bounds, rifs.start, *corners);
        if (by <= 0) return box(corners->low, corners->high);
        replaced("box", by);
    } else if (!std::holds_alternative<AutoVolume>(*object.volume)) {
        const bool cone = std::holds_alternative<ConeVolume>(*object.volume);
        diagnostics.warning(object.volume_position,
                            fmt::format("{} volumes are not supported yet: a computed volume is "
                                        "used for object \"{}\" instead",
                                        cone ? "cone" : "cylinder", object.name));
    }
    return std::nullopt;
}

}  // namespace

std::vector<CompiledVolume> choose_volumes(const ObjectBlock& object, VolumeKind kind,
                                           const Rifs& rifs, const std::vector<Bounds>& bounds,
                                           Diagnostics& diagnostics) {
    std::optional<CompiledVolume> declared;
    if (object.volume && kind == VolumeKind::automatic) {
        declared = declared_volume(object, rifs, bounds, diagnostics);
    }
    VolumeKind chosen = computed_kind(kind, bounds[static_cast<std::size_t>(rifs.start)]);
    if (declared) {
        chosen = declared->kind == kernels::Volume::sphere ? VolumeKind::sphere : VolumeKind::box;
    }
    std::vector<CompiledVolume> volumes;
    for (const Bounds& b : bounds) {
        volumes.push_back(chosen == VolumeKind::sphere ? sphere(b.ball.center, b.ball.radius)
                                                       : computed_box(b.box));
    }
    if (declared) volumes[static_cast<std::size_t>(rifs.start)] = *declared;
    return volumes;
}

}  // namespace pxm::host
