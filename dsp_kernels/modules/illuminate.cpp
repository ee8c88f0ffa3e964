// Module "illuminate" of the node program: Lambert's law (Eq. 17.1) under ambient and directional
// light. Measured by tools/measure_modules, never linked into pxm (docs/program-memory.md).
#include "dsp_kernels/modules/measured_node.hpp"
#include "dsp_kernels/shade.hpp"

namespace pxm::kernels {

template Vec3<float> illuminate(Node&, const Surface<float>&, const Vec3<float>&) noexcept;

}  // namespace pxm::kernels
