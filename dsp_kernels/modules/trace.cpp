// Module "trace" of the node program: the loop over pixels and the first cell of each eye ray.
// Measured by tools/measure_modules, never linked into pxm (docs/program-memory.md).
#include "dsp_kernels/modules/pixel_store.hpp"

namespace pxm::kernels {

template void pixel_program<plain_features>(Node&, const PixelShare&, const PixelStore&) noexcept;
template void render_pixel<plain_features>(Node&, FrameConstants<float>&, Heap<Node>&,
                                           std::uint32_t, std::uint32_t,
                                           PixelResult<float>&) noexcept;

}  // namespace pxm::kernels
