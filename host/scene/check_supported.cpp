// What the language can say and this version cannot render.
#include <fmt/format.h>

#include "host/scene/check.hpp"
#include "host/scene/range_check.hpp"
#include "host/scene/words.hpp"

namespace pxm::host {
namespace {

void unsupported(const Position& position, const std::string& what, Diagnostics& diagnostics) {
    diagnostics.error(position, what + ": not supported yet");
}

void check_object(const ObjectBlock& object, Diagnostics& diagnostics) {
    const std::string name = block_name("object", object.name);
    if (!object.ifs)
        unsupported(object.position, name + ": an object without an 'ifs'", diagnostics);
    if (object.volume && std::holds_alternative<HullVolume>(*object.volume))
        unsupported(object.volume_position, name + ": 'hull'", diagnostics);
    if (object.opacity && *object.opacity < 1)
        unsupported(object.opacity_position, name + ": 'opacity' below 1", diagnostics);
    if (object.reflect && *object.reflect > 0)
        unsupported(object.reflect_position, name + ": 'reflect' above 0", diagnostics);
}

void check_render(const RenderBlock& render, Diagnostics& diagnostics) {
    if (render.covers && std::holds_alternative<Covers>(*render.covers))
        unsupported(render.covers_position, "render: 'covers'", diagnostics);
    if (render.samples && *render.samples > 1)
        unsupported(render.samples_position, "render: 'samples' above 1", diagnostics);
    if (render.intersect == IntersectMethod::fast)
        unsupported(
            render.intersect_position,
            fmt::format("render: 'intersect: {}'", word_of(intersect_words, *render.intersect)),
            diagnostics);
    if (render.volume == VolumeKind::oriented || render.volume == VolumeKind::hull)
        unsupported(render.volume_position,
                    fmt::format("render: 'volume: {}'", word_of(volume_words, *render.volume)),
                    diagnostics);
}

}  // namespace

void check_supported(const Scene& scene, Diagnostics& diagnostics) {
    for (const ObjectBlock& object : scene.objects) check_object(object, diagnostics);
    for (const PlaneBlock& plane : scene.planes)
        unsupported(plane.position, block_name("plane", plane.name), diagnostics);
    for (const TextureBlock& texture : scene.textures)
        unsupported(texture.position, block_name("texture", texture.name), diagnostics);
    for (const LightBlock& light : scene.lights)
        if (light.shadow.value_or(false))
            unsupported(light.shadow_position, block_name("light", light.name) + ": 'shadow: on'",
                        diagnostics);
    if (scene.render) check_render(*scene.render, diagnostics);
}

}  // namespace pxm::host
