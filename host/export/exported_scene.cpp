#include "host/export/exported_scene.hpp"

#include <algorithm>

#include "host/compile/proven_rifs.hpp"
#include "host/compile/volumes.hpp"
#include "host/scene/default_objects.hpp"

namespace pxm::host {

namespace {

constexpr glm::dvec3 base_color{0.9, 0.9, 0.9};

void add_volume(const CompiledVolume& volume, const std::optional<Mesh>& shape,
                ExportedObject& object) {
    object.meshes.push_back(shape ? *shape : mesh_of(volume));
    object.diameters.push_back(volume.diameter);
}

/// Nothing if an error was added.
std::optional<ExportedObject> exported(const Scene& scene, const ObjectBlock& block,
                                       VolumeKind kind, const std::optional<Mesh>& shape,
                                       Diagnostics& diagnostics) {
    ExportedObject object;
    object.name = block.name;
    object.instance = compose(block.commands);
    const glm::dvec4 paint = block.color.value_or(glm::dvec4{0.0});
    object.color = base_color * (1 - paint.a) + glm::dvec3{paint} * paint.a;
    if (!block.ifs) {
        add_volume(primitive_volume(*block.volume), shape, object);
        return object;
    }
    const auto ifs = std::ranges::find(scene.ifs, *block.ifs, &IfsBlock::name);
    auto proven = prove_rifs(*ifs, diagnostics);
    if (!proven) return std::nullopt;
    const std::vector<Bounds> bounds = bound(proven->rifs, proven->contraction);
    for (const CompiledVolume& volume :
         choose_volumes(block, kind, proven->rifs, bounds, diagnostics))
        add_volume(volume, shape, object);
    for (const MapBlock& map : ifs->maps)
        object.colors.push_back(map.color.value_or(glm::dvec4{0.0}));
    object.levels = block.levels;
    object.rifs = std::move(proven->rifs);
    return object;
}

}  // namespace

std::vector<ExportedObject> exported_objects(const Scene& scene, VolumeKind kind,
                                             const std::optional<Mesh>& shape,
                                             Diagnostics& diagnostics) {
    std::vector<ExportedObject> objects;
    for (const ObjectBlock& block : objects_of(scene)) {
        auto object = exported(scene, block, kind, shape, diagnostics);
        if (object) objects.push_back(std::move(*object));
    }
    if (objects.empty() && !diagnostics.has_errors())
        diagnostics.error({}, "the scene has no object to export");
    return objects;
}

}  // namespace pxm::host
