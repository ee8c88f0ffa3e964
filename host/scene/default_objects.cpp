#include "host/scene/default_objects.hpp"

#include <algorithm>

namespace pxm::host {

namespace {

bool is_texture(const IfsBlock& ifs, const Scene& scene) {
    return std::ranges::any_of(scene.textures, [&](const TextureBlock& texture) {
        const auto* source = texture.source ? std::get_if<IfsTexture>(&*texture.source) : nullptr;
        return source && source->ifs == ifs.name;
    });
}

}  // namespace

std::vector<ObjectBlock> objects_of(const Scene& scene) {
    if (!scene.objects.empty()) return scene.objects;
    std::vector<ObjectBlock> objects;
    for (const IfsBlock& ifs : scene.ifs) {
        if (is_texture(ifs, scene)) continue;
        ObjectBlock object;
        object.name = ifs.name;
        object.ifs = ifs.name;
        object.ifs_position = object.position = ifs.position;
        objects.push_back(object);
    }
    return objects;
}

}  // namespace pxm::host
