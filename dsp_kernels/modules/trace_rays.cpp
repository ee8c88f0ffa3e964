// Module "trace_rays" of the node program: the same with shadows and mirrors.
// Measured by tools/measure_modules, never linked into pxm (docs/program-memory.md).
#include "dsp_kernels/modules/pixel_store.hpp"

namespace pxm::kernels {

template void pixel_program<ray_features>(Node&, const PixelShare&, const PixelStore&) noexcept;
template void render_pixel<ray_features>(Node&, FrameConstants<float>&, Heap<Node>&, std::uint32_t,
                                         std::uint32_t, PixelResult<float>&) noexcept;

}  // namespace pxm::kernels
