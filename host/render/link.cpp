#include "host/render/link.hpp"

#include <algorithm>

namespace pxm::host {

namespace {

bool any_volume(const CompiledScene& scene, kernels::Volume kind) {
    return std::ranges::any_of(scene.shapes, [kind](const CompiledShape& shape) {
        return std::ranges::any_of(
            shape.sets, [kind](const CompiledSet& set) { return set.volume.kind == kind; });
    });
}

bool any_light(const CompiledScene& scene, kernels::LightKind kind) {
    return std::ranges::any_of(scene.lights,
                               [kind](const CompiledLight& light) { return light.kind == kind; });
}

}  // namespace

NodeProgram link(const CompiledScene& scene) {
    NodeProgram program;
    const auto take = [&](const char* name, bool needed, const char* why, const char* why_not) {
        (needed ? program.modules : program.left_out).push_back({name, needed ? why : why_not});
    };
    const bool objects = !scene.objects.empty();
    const bool polar = std::ranges::any_of(scene.shapes, [](const CompiledShape& shape) {
        return shape.lipschitz == kernels::Lipschitz::polar;
    });
    const bool lifted = std::ranges::any_of(scene.shapes, &CompiledShape::lifted);
    take("camera", true, "every pixel has an eye ray", "");
    take("intersect", objects, "ifs objects", "no objects");
    take("heap", objects, "ifs objects", "no objects");
    take("next_after", objects, "a heap may overflow", "no objects");
    take("sphere", any_volume(scene, kernels::Volume::sphere), "bounding spheres",
         "no bounding sphere");
    take("box", any_volume(scene, kernels::Volume::box), "bounding boxes", "no bounding box");
    take("polar", polar, "maps that are no similitudes, or lipschitz: polar",
         "Lipschitz constants by product or determinant");
    take("flatness", lifted, "lifted singular maps", "no singular map");
    take("shade", objects, "objects are shaded", "no objects");
    take("point_light", any_light(scene, kernels::LightKind::point), "point lights",
         "directional lights only");
    return program;
}

}  // namespace pxm::host
