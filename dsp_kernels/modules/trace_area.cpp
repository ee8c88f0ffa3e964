// Module "trace_area" of the node program: the same with local covers by area, shadows and mirrors.
// Measured by tools/measure_modules, never linked into pxm (docs/program-memory.md).
#include "dsp_kernels/modules/pixel_store.hpp"

namespace pxm::kernels {

template void pixel_program<area_features>(Node&, const PixelShare&, const PixelStore&) noexcept;
template void render_pixel<area_features>(Node&, FrameConstants<float>&, Heap<Node>&, std::uint32_t,
                                          std::uint32_t, PixelResult<float>&) noexcept;

}  // namespace pxm::kernels
