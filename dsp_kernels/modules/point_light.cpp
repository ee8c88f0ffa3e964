// Module "point_light" of the node program: point lights on the cells of a path (Sec. 17.3).
// Measured by tools/measure_modules, never linked into pxm (docs/program-memory.md).
#include "dsp_kernels/lights.hpp"
#include "dsp_kernels/modules/measured_node.hpp"

namespace pxm::kernels {

template Vec3<float> direction_to_point_light(Node&, const Vec3<float>&,
                                              const Vec3<float>&) noexcept;
template float facing_point_light(Node&, const LitPlace<float>&, const Vec3<float>&,
                                  ShadingMode) noexcept;

}  // namespace pxm::kernels
