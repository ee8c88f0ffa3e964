#include "host/export/systems_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "host/fractal/dimension/default_weights.hpp"
#include "host/scene/default_objects.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

std::vector<SystemOfObject> systems_of(const Scene& scene, std::string& messages) {
    std::vector<SystemOfObject> systems;
    Diagnostics diagnostics;
    for (const ObjectBlock& object : objects_of(scene)) {
        if (!object.ifs) {
            messages += fmt::format("object \"{}\" is no system of maps: left out\n",
                                    printable(object.name));
            continue;
        }
        const auto block = std::ranges::find(scene.ifs, *object.ifs, &IfsBlock::name);
        auto proven = prove_rifs(*block, diagnostics);
        if (!proven) continue;
        std::vector<double> weights = default_weights(proven->rifs);
        for (std::size_t i = 0; i < weights.size(); ++i)
            if (block->maps[i].weight) weights[i] = *block->maps[i].weight;
        systems.push_back({object, &*block, std::move(proven->rifs), compose(object.commands),
                           std::move(weights)});
    }
    if (systems.empty() && !diagnostics.has_errors())
        diagnostics.error({}, "the scene has no system of maps to export");
    diagnostics.throw_if_errors(scene.files);
    return systems;
}

bool is_of_plane(const Affine& map) {
    const glm::dmat3& m = map.linear;
    return m[0][2] == 0 && m[1][2] == 0 && m[2][0] == 0 && m[2][1] == 0 && map.translation.z == 0;
}

bool faces_plane(const CameraBlock& camera) {
    if (!camera.orthographic || !camera.eye || !camera.look || camera.zoom) return false;
    const DecimalVec3& eye = *camera.eye;
    const DecimalVec3& look = *camera.look;
    const glm::dvec3 up = camera.up.value_or(glm::dvec3{0, 1, 0});
    return eye[0].value == look[0].value && eye[1].value == look[1].value &&
           eye[2].value < look[2].value && up.x == 0 && up.z == 0 && up.y > 0;
}

}  // namespace pxm::host
