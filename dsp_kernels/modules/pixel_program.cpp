// Module "pixel_program" of the node program: the loop over the node's pixels, and the store of a
// finished one. Measured by tools/measure_modules, never linked into pxm (docs/program-memory.md).
#include "dsp_kernels/pixel_program.hpp"
#include "dsp_kernels/modules/pixel_store.hpp"

namespace pxm::kernels {

template void pixel_program(Node&, const PixelShare&, const PixelStore&) noexcept;
template void render_pixel(Node&, FrameConstants<float>&, Heap<Node>&, std::uint32_t, std::uint32_t,
                           PixelResult<float>&) noexcept;
template FrameConstants<float> read_frame_constants(Node&) noexcept;

}  // namespace pxm::kernels
