#include "host/studio/scene_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "host/compile/placed.hpp"
#include "host/compile/view.hpp"
#include "host/scene/default_objects.hpp"

namespace pxm::host {

namespace {

/// The systems that objects show, bounded, by name.
std::map<std::string, Fractal> fractals_of(const Scene& scene,
                                           const std::vector<ObjectBlock>& objects,
                                           Diagnostics& diagnostics) {
    std::map<std::string, Fractal> fractals;
    for (const ObjectBlock& object : objects) {
        if (!object.ifs || fractals.contains(*object.ifs)) continue;
        const auto ifs = std::ranges::find(scene.ifs, *object.ifs, &IfsBlock::name);
        auto made = make_fractal(*ifs, diagnostics);
        if (!made) continue;
        made->bounds = bound(made->rifs, made->contraction);
        fractals.emplace(*object.ifs, std::move(*made));
    }
    return fractals;
}

/// The ball that the view of the whole is made around.
Ball ball_of(const std::vector<ObjectBlock>& blocks, std::map<std::string, Fractal>& fractals) {
    std::vector<Placed> objects;
    for (const ObjectBlock& block : blocks) {
        const auto found = block.ifs ? fractals.find(*block.ifs) : fractals.end();
        if (block.ifs && found == fractals.end()) continue;
        objects.push_back({&block, block.ifs ? &found->second : nullptr, compose(block.commands)});
    }
    return ball_around(objects);
}

std::array<std::string, 3> texts_of(const std::optional<DecimalVec3>& written,
                                    const glm::dvec3& computed) {
    std::array<std::string, 3> texts;
    for (std::size_t i = 0; i < texts.size(); ++i) {
        texts[i] = written && !(*written)[i].text.empty()
                       ? (*written)[i].text
                       : fmt::format("{}", written ? (*written)[i].value
                                                   : computed[static_cast<glm::length_t>(i)]);
    }
    return texts;
}

}  // namespace

SceneView view_of(const Scene& scene, const PixelSize& size, Diagnostics& diagnostics) {
    CameraBlock camera = scene.camera.value_or(CameraBlock{});
    SceneView result;
    result.zoom = camera.zoom.value_or(1);
    camera.zoom.reset();
    const std::vector<ObjectBlock> objects = objects_of(scene);
    auto fractals = fractals_of(scene, objects, diagnostics);
    result.ball = ball_of(objects, fractals);
    for (const auto& [name, fractal] : fractals) {
        const Rifs& rifs = fractal.rifs;
        result.systems[name] = {rifs.follow_sets, fractal.bounds, rifs.follow_of, rifs.start};
        result.attractors[name] = fractal.bounds[static_cast<std::size_t>(rifs.start)].ball;
    }
    const View view = make_view(camera, size, result.ball, 1);
    result.eye = texts_of(camera.eye, view.eye);
    result.look = texts_of(camera.look, result.ball.center);
    result.up = camera.up.value_or(result.up);
    result.half_width = view.half_width;
    result.orthographic = camera.orthographic;
    return result;
}

}  // namespace pxm::host
