#include "host/wide/tile/reference_fallback.hpp"

#include <algorithm>

#include "host/engine/gather.hpp"
#include "host/node_program/crowded.hpp"
#include "host/wide/tile/to_node.hpp"

namespace pxm::host::wide {

ReferenceFallback::ReferenceFallback(const CompiledScene& whole, const WideScene& wide)
    : scene(whole) {
    scene.objects.clear();
    for (std::size_t i = 0; i < whole.objects.size(); ++i) {
        if (wide.why_not[i].empty()) continue;
        scene.objects.push_back(whole.objects[i]);
        indices.push_back(static_cast<int>(i));
    }
    if (!scene.objects.empty()) block = make_scene_block<double>(scene);
}

FallbackSearch::FallbackSearch(const ReferenceFallback& rest)
    : rest_(rest),
      node_(make_native_node<Node>(rest.scene, rest.block)),
      heap_(node_),
      constants_(kernels::read_frame_constants(node_)) {}

bool FallbackSearch::meets(const LoneRay& ray, double end) {
    constants_.search.ray = to_node(ray);
    constants_.search.start = ray.start;
    constants_.search.end = std::min(end, kernels::far_away<double>);
    constants_.search.pixel = {ray.pixel_at_origin, ray.pixel_growth};
    counts_ = {};
    result_ = kernels::first_cell(node_, constants_.search, heap_, counts_);
    return result_.outcome != kernels::Outcome::miss;
}

FallbackHit FallbackSearch::see(ShadedHit& seen) {
    const kernels::Cell<double>& cell = result_.cell;
    const kernels::Sighting<double> sighting{constants_.search, cell, 0};
    kernels::LitPlace<double> lit;
    lit.surface = kernels::surface_at(node_, sighting, constants_.shading);
    lit.point = kernels::point_at(node_, constants_.search.ray, cell.key);
    lit.pixel = kernels::pixel_at(node_, constants_.search, cell.object, cell.key);
    lit.sighting = &sighting;
    seen.color = to_floats(lit.surface.color);
    seen.normal = to_floats(lit.surface.normal);
    seen.facing.resize(rest_.scene.lights.size());
    for (std::size_t i = 0; i < seen.facing.size(); ++i) {
        const CompiledLight& light = rest_.scene.lights[i];
        const kernels::Vec3<double> place = to_node(light.place);
        seen.facing[i] = static_cast<float>(
            light.kind == kernels::LightKind::directional
                ? kernels::facing(node_, lit.surface.normal, place)
                : kernels::facing_point_light(node_, lit, place, constants_.shading));
    }
    seen.object = rest_.indices[object_index<double>(rest_.block, cell.object)];
    seen.level = static_cast<int>(cell.level);
    seen.word =
        word_hash(rest_.scene.objects[object_index<double>(rest_.block, cell.object)], cell);
    return {cell.key, static_cast<float>(lit.surface.diffuse),
            static_cast<float>(lit.surface.reflect), lit.pixel};
}

}  // namespace pxm::host::wide
