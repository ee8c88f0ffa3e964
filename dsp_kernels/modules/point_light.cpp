// Module "point_light" of the node program: the direction to a point light.
// Measured by tools/measure_modules, never linked into pxm (docs/program-memory.md).
#include "dsp_kernels/modules/measured_node.hpp"
#include "dsp_kernels/shade.hpp"

namespace pxm::kernels {

template Vec3<float> direction_to_point_light(Node&, const Vec3<float>&,
                                              const Vec3<float>&) noexcept;

}  // namespace pxm::kernels
