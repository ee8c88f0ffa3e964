// Module "pixel_program" of the node program: what is the same for all pixels.
// Measured by tools/measure_modules, never linked into pxm (docs/program-memory.md).
#include "dsp_kernels/pixel_program.hpp"
#include "dsp_kernels/modules/measured_node.hpp"

namespace pxm::kernels {

template FrameConstants<float> read_frame_constants(Node&) noexcept;

}  // namespace pxm::kernels
