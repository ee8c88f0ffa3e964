#include "host/render/volumes.hpp"

#include <fmt/format.h>

#include <glm/geometric.hpp>
#include <numbers>
#include <optional>

#include "host/fractal/short_by.hpp"
#include "host/render/bounding_volume.hpp"
#include "host/render/computed_volume.hpp"

namespace pxm::host {

namespace {

/// The mean area of a volume's shadow: what a ray in a random direction has to hit (Cauchy: a
/// quarter of the surface of a convex body).
double mean_shadow(const Ball& ball) { return std::numbers::pi * ball.radius * ball.radius; }
double mean_shadow(const Box& volume) {
    const glm::dvec3 e = volume.high - volume.low;
    return (e.x * e.y + e.y * e.z + e.z * e.x) / 2;
}

kernels::Volume computed_kind(VolumeKind kind, const Bounds& outermost) {
    switch (kind) {
        case VolumeKind::sphere:
            return kernels::Volume::sphere;
        case VolumeKind::box:
            return kernels::Volume::box;
        case VolumeKind::oriented:
            return kernels::Volume::oriented;
        case VolumeKind::hull:
            return kernels::Volume::hull;
        case VolumeKind::automatic:
            break;
    }
    // Spheres stay a pixel thick down to the last cell: curves and sheets edge on are not missed.
    if (is_flat(outermost.box)) return kernels::Volume::sphere;
    return mean_shadow(outermost.ball) <= mean_shadow(outermost.box) ? kernels::Volume::sphere
                                                                     : kernels::Volume::box;
}

const char* name_of(const DeclaredVolume& volume) {
    constexpr std::array names{"volume", "sphere", "box", "cone", "cylinder", "hull"};
    return names[volume.index()];
}

/// The declared volume if it can be used; else nothing, with a warning that says why.
std::optional<CompiledVolume> declared_volume(const ObjectBlock& object, const Rifs& rifs,
                                              const std::vector<Bounds>& bounds,
                                              Diagnostics& diagnostics) {
    const DeclaredVolume& declared = *object.volume;
    const double by = short_by(rifs, bounds, rifs.start, declared);
    if (by <= 0) return primitive_volume(declared);
    diagnostics.warning(
        object.volume_position,
        fmt::format("the {} of object \"{}\" does not contain the attractor (short by {:.3g}): "
                    "a computed volume is used instead",
                    name_of(declared), object.name, by));
    return std::nullopt;
}

}  // namespace

CompiledVolume primitive_volume(const DeclaredVolume& declared) {
    if (const auto* ball = std::get_if<SphereVolume>(&declared)) {
        return sphere_volume(ball->center, ball->radius);
    }
    if (const auto* corners = std::get_if<BoxVolume>(&declared)) {
        return box_volume(corners->low, corners->high);
    }
    return std::holds_alternative<ConeVolume>(declared) ? cone_volume() : cylinder_volume();
}

std::vector<CompiledVolume> choose_volumes(const ObjectBlock& object, VolumeKind kind,
                                           const Rifs& rifs, const std::vector<Bounds>& bounds,
                                           Diagnostics& diagnostics) {
    const auto start = static_cast<std::size_t>(rifs.start);
    kernels::Volume chosen = computed_kind(kind, bounds[start]);
    std::optional<CompiledVolume> declared;
    if (object.volume && kind == VolumeKind::automatic) {
        if (std::holds_alternative<HullVolume>(*object.volume)) {
            chosen = kernels::Volume::hull;
        } else if (!std::holds_alternative<AutoVolume>(*object.volume)) {
            declared = declared_volume(object, rifs, bounds, diagnostics);
        }
    }
    const bool as_declared = declared && (declared->kind == kernels::Volume::sphere ||
                                          declared->kind == kernels::Volume::box);
    if (as_declared) chosen = declared->kind;  // inside it too
    VolumeComputer computer(rifs, bounds);
    std::vector<CompiledVolume> volumes;
    for (std::size_t set = 0; set < bounds.size(); ++set) {
        volumes.push_back(declared && set == start ? *declared : computer.make(chosen, set));
    }
    return volumes;
}

}  // namespace pxm::host
