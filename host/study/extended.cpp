#include "host/study/extended.hpp"

#include "host/engine/gather.hpp"
#include "host/node_program/instances.hpp"
#include "host/node_program/native_node.hpp"

namespace pxm::host {

RenderResult render_extended(const RenderRequest& request, const RunControl& control) {
    using Real = long double;
    const CompiledScene scene = compiled_scene_of(request);
    const std::vector<std::uint32_t> block = make_scene_block<Real>(scene);
    NativeNode<Real> node(block, scene.texture_words, scene.heap, sizeof(kernels::Cell<Real>));
    RenderResult result;
    result.frame = Frame(scene.size, scene.crop);
    const auto at = [](long v) { return static_cast<std::uint32_t>(v); };
    const kernels::PixelShare all{
        at(scene.crop.x0), at(scene.crop.y0), at(scene.crop.x1), at(scene.crop.y1), 1, 1};
    const auto store = [&](std::uint32_t x, std::uint32_t y,
                           const kernels::PixelResult<Real>& pixel) {
        gather_pixel(scene, block, pixel, result.frame.at(x, y), result.statistics.rays);
        result.stopped = control.stop && *control.stop;
        return !result.stopped;
    };
    with_needed_features(scene, [&]<kernels::Features features>() {
        kernels::pixel_program<features>(node, all, store);
    });
    return result;
}

}  // namespace pxm::host
