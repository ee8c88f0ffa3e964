#include "host/studio/picked_cell.hpp"

#include <cstdint>

#include "dsp_kernels/pixel_program.hpp"
#include "host/node_program/crowded.hpp"
#include "host/node_program/instances.hpp"
#include "host/node_program/native_node.hpp"
#include "host/node_program/write_scene_block.hpp"

namespace pxm::host {

std::optional<PickedCell> pick_cell(const CompiledScene& scene, long x, long y) {
    using Real = double;
    const std::vector<std::uint32_t> block = make_scene_block<Real>(scene);
    auto node = make_native_node<NativeNode<Real>>(scene, block);
    kernels::Heap<NativeNode<Real>> heap(node);
    auto frame = kernels::read_frame_constants(node);
    kernels::PixelResult<Real> result;
    with_needed_features(scene, [&]<kernels::Features features>() {
        kernels::render_pixel<features>(node, frame, heap, static_cast<std::uint32_t>(x),
                                        static_cast<std::uint32_t>(y), result);
    });
    if (result.floor.plane != 0 || result.found.outcome == kernels::Outcome::miss)
        return std::nullopt;
    const kernels::Cell<Real>& cell = result.found.cell;
    const CompiledObject& object = scene.objects[object_index<Real>(block, cell.object)];
    PickedCell picked{object.origin, object.prefix, cell.key * scene.unit};
    for (std::uint32_t i = 0; i < cell.level; ++i)
        picked.word.push_back(static_cast<int>(cell.word.get(i, cell.bits)));
    return picked;
}

}  // namespace pxm::host
