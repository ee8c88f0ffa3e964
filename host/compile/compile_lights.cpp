#include "host/compile/compile_lights.hpp"

#include <glm/geometric.hpp>

namespace pxm::host {

std::vector<CompiledLight> compile_lights(const Scene& scene, const glm::dvec3& eye, double unit) {
    std::vector<LightBlock> lights = scene.lights;
    if (lights.empty()) {
        lights.emplace_back();
        lights.back().direction = glm::dvec3{0.5, 1, -0.7};
    }
    std::vector<CompiledLight> compiled;
    for (const LightBlock& light : lights) {
        CompiledLight result;
        result.color = light.color.value_or(glm::dvec3{1.0});
        if (light.location) {
            result.kind = kernels::LightKind::point;
            result.place = (*light.location - eye) / unit;
        } else {
            result.place = glm::normalize(*light.direction);
        }
        result.shadow = light.shadow.value_or(false);
        compiled.push_back(result);
    }
    return compiled;
}

}  // namespace pxm::host
