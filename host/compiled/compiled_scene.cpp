#include "host/compiled/compiled_scene.hpp"

#include <algorithm>

namespace pxm::host {

Rerooted rerooted(const CompiledScene& scene) {
    Rerooted result;
    for (const CompiledObject& object : scene.objects) {
        result.objects += object.prefix.empty() ? 0 : 1;
        result.levels = std::max(result.levels, object.prefix.size());
    }
    return result;
}

std::size_t object_count(const CompiledScene& scene) {
    return scene.objects.empty() ? 0 : static_cast<std::size_t>(scene.objects.back().origin) + 1;
}

bool needs_covers(const CompiledScene& scene) {
    return scene.covers || std::ranges::any_of(scene.objects, [](const CompiledObject& object) {
               return object.opacity < 1;
           });
}

bool needs_shadows(const CompiledScene& scene) {
    return std::ranges::any_of(scene.lights, &CompiledLight::shadow);
}

bool needs_mirrors(const CompiledScene& scene) {
    return scene.bounces > 0 &&
           (std::ranges::any_of(scene.objects,
                                [](const auto& object) { return object.reflect > 0; }) ||
            std::ranges::any_of(scene.planes, [](const auto& plane) { return plane.reflect > 0; }));
}

bool needs_plain_features(const CompiledScene& scene) {
    return !needs_covers(scene) && !needs_shadows(scene) && !needs_mirrors(scene);
}

}  // namespace pxm::host
