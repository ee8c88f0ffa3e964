// Module "shadow" of the node program: shadow rays (Sec. 15.2).
// Measured by tools/measure_modules, never linked into pxm (docs/program-memory.md).
#include "dsp_kernels/shadow.hpp"
#include "dsp_kernels/modules/measured_node.hpp"

namespace pxm::kernels {

template Search<float> search_to_light(Node&, const Search<float>&, const Vec3<float>&, float,
                                       const Vec3<float>&) noexcept;

}  // namespace pxm::kernels
