// The scene as a whole: names, references, counts. Blocks are checked one by one in
// check_fractal.cpp and check_setting.cpp.
#include "host/scene/check/check.hpp"

#include <fmt/format.h>

#include <unordered_map>

#include "host/scene/check/check_blocks.hpp"
#include "host/scene/check/limits.hpp"
#include "host/scene/check/range_check.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {
namespace {

using Names = std::unordered_map<std::string, Position>;

/// The names of blocks of one kind; a name given twice is an error at its second place.
template <class Block>
Names unique_names(std::string_view kind, const std::vector<Block>& blocks,
                   Diagnostics& diagnostics) {
    Names names;
    for (const Block& block : blocks) {
        if (block.name.empty()) continue;
        const auto [first, added] = names.emplace(block.name, block.position);
        if (!added)
            diagnostics.error(block.position,
                              fmt::format("{} is defined twice (first in line {})",
                                          block_name(kind, block.name), first->second.line));
    }
    return names;
}

void check_reference(std::string_view kind, const std::string& name, const Position& position,
                     const Names& names, Diagnostics& diagnostics) {
    if (!names.contains(name))
        diagnostics.error(position, fmt::format("there is no {}", block_name(kind, name)));
}

void check_names(const Scene& scene, Diagnostics& diagnostics) {
    const Names ifs = unique_names("ifs", scene.ifs, diagnostics);
    const Names textures = unique_names("texture", scene.textures, diagnostics);
    unique_names("object", scene.objects, diagnostics);
    unique_names("plane", scene.planes, diagnostics);
    unique_names("light", scene.lights, diagnostics);
    for (const IfsBlock& block : scene.ifs) unique_names("map", block.maps, diagnostics);
    for (const ObjectBlock& object : scene.objects)
        if (object.ifs) check_reference("ifs", *object.ifs, object.ifs_position, ifs, diagnostics);
    for (const PlaneBlock& plane : scene.planes)
        for (const TextureReference& texture : plane.textures)
            check_reference("texture", texture.name, texture.position, textures, diagnostics);
    for (const TextureBlock& texture : scene.textures)
        if (const auto* source =
                texture.source ? std::get_if<IfsTexture>(&*texture.source) : nullptr)
            check_reference("ifs", source->ifs, texture.source_position, ifs, diagnostics);
}

void check_counts(const Scene& scene, Diagnostics& diagnostics) {
    if (scene.ifs.empty() && scene.objects.empty() && scene.planes.empty())
        diagnostics.error({}, "nothing to render: the scene has no ifs, object or plane");
    std::size_t maps = 0;
    for (const IfsBlock& ifs : scene.ifs) {
        maps += ifs.maps.size();
        if (ifs.maps.size() > maps_an_ifs)
            diagnostics.error(ifs.position, fmt::format("{}: {} maps, but an ifs may have {}",
                                                        block_name("ifs", ifs.name),
                                                        ifs.maps.size(), maps_an_ifs));
    }
    if (maps > maps_a_scene)
        diagnostics.error(scene.ifs.back().position,
                          fmt::format("{} maps, but a scene may have {}", maps, maps_a_scene));
}

}  // namespace

void check_scene(const Scene& scene, Diagnostics& diagnostics) {
    check_counts(scene, diagnostics);
    check_names(scene, diagnostics);
    for (const IfsBlock& block : scene.ifs) check_ifs(block, diagnostics);
    for (const ObjectBlock& block : scene.objects) check_object(block, diagnostics);
    for (const PlaneBlock& block : scene.planes) check_plane(block, diagnostics);
    for (const TextureBlock& block : scene.textures) check_texture(block, diagnostics);
    for (const LightBlock& block : scene.lights) check_light(block, diagnostics);
    if (scene.camera) check_camera(*scene.camera, diagnostics);
    if (scene.image) check_image(*scene.image, diagnostics);
    if (scene.render) check_render(*scene.render, diagnostics);
    if (scene.animation) check_animation(*scene.animation, diagnostics);
}

}  // namespace pxm::host
