// Module "illuminate" of the node program: Lambert's law (Eq. 17.1).
// Measured by tools/measure_modules, never linked into pxm (docs/program-memory.md).
#include "dsp_kernels/lights.hpp"
#include "dsp_kernels/modules/measured_node.hpp"

namespace pxm::kernels {

template float facing(Node&, const Vec3<float>&, const Vec3<float>&) noexcept;

}  // namespace pxm::kernels
