// Module "mirror" of the node program: mirror rays (Sec. 15.3).
// Measured by tools/measure_modules, never linked into pxm (docs/program-memory.md).
#include "dsp_kernels/modules/measured_node.hpp"
#include "dsp_kernels/reflection.hpp"

namespace pxm::kernels {

template Search<float> mirrored(Node&, const Search<float>&, const Vec3<float>&, float,
                                const Vec3<float>&) noexcept;

}  // namespace pxm::kernels
