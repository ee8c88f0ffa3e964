#include "host/export/gltf_layout.hpp"

namespace pxm::host {

GltfLayout gltf_layout(const ExportScene& scene, const CellTally& tally) {
    constexpr std::uint64_t vec3 = 12, vec4 = 16, index = 4, rgba = 4;  // bytes
    GltfLayout layout;
    const auto place = [&](std::uint64_t bytes) {
        const std::uint64_t at = layout.bytes;
        layout.bytes += bytes;
        return at;
    };
    for (std::size_t i = 0; i < scene.systems.size(); ++i)
        for (std::size_t s = 0; s < tally.systems[i].size(); ++s) {
            const SetTally& cells = tally.systems[i][s];
            if (cells.cells == 0) continue;
            const Mesh& shape = scene.systems[i].sets[s].shape;
            GltfGroup group;
            group.system = i;
            group.set = s;
            group.instanced = !cells.sheared && !scene.geometry;
            group.cells = cells.cells;
            const std::uint64_t copies = group.instanced ? 1 : group.cells;
            group.vertices = copies * shape.vertices.size();
            group.indices = copies * 3 * triangles_of(shape).size();
            group.positions_at = place(group.vertices * vec3);
            group.indices_at = place(group.indices * index);
            const bool colored = scene.systems[i].colored;
            if (group.instanced) {
                group.translations_at = place(group.cells * vec3);
                if (cells.turned) group.rotations_at = place(group.cells * vec4);
                group.scales_at = place(group.cells * vec3);
                if (colored) group.colors_at = place(group.cells * vec3);
            } else if (colored) {
                group.colors_at = place(group.vertices * rgba);
            }
            layout.groups.push_back(group);
        }
    return layout;
}

}  // namespace pxm::host
