#include "host/compile/method.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/math/lipschitz.hpp"

namespace pxm::host {

namespace {

bool computes_its_volume(const ObjectBlock& object) {
    return !object.volume || std::holds_alternative<AutoVolume>(*object.volume);
}

}  // namespace

kernels::Method chosen_method(const RenderBlock& render) {
    return render.intersect == IntersectMethod::fast ? kernels::Method::fast
                                                     : kernels::Method::heap;
}

VolumeKind volume_kind(const RenderBlock& render, const ObjectBlock& object) {
    const VolumeKind kind = render.volume.value_or(VolumeKind::automatic);
    const bool free = kind == VolumeKind::automatic && computes_its_volume(object);
    return free && chosen_method(render) == kernels::Method::fast ? VolumeKind::sphere : kind;
}

void require_homotheties(const IfsBlock& block, const Rifs& rifs, Diagnostics& diagnostics) {
    for (std::size_t i = 0; i < rifs.maps.size(); ++i) {
        if (classify(rifs.maps[i]) == MapKind::homothety) continue;
        diagnostics.error(
            block.maps[i].position,
            fmt::format("intersect: fast takes maps that scale uniformly and translate; map \"{}\" "
                        "of ifs \"{}\" does more",
                        rifs.map_names[i], block.name));
        return;
    }
}

void require_solid(const RenderBlock& render, const CompiledScene& scene,
                   Diagnostics& diagnostics) {
    if (!needs_covers(scene)) return;
    diagnostics.error(render.intersect_position,
                      "intersect: fast finds the first cell along a ray; local covers and "
                      "translucent objects take the cells behind it too");
}

void require_spheres(const ObjectBlock& object, const CompiledShape& shape,
                     Diagnostics& diagnostics) {
    const bool spheres = std::ranges::all_of(shape.sets, [](const CompiledSet& set) {
        return set.volume.kind == kernels::Volume::sphere;
    });
    if (spheres) return;
    diagnostics.error(object.position,
                      fmt::format("intersect: fast takes bounding spheres; object \"{}\" has "
                                  "another volume (say volume: sphere)",
                                  object.name));
}

}  // namespace pxm::host
