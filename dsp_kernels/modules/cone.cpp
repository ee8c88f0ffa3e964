// Module "cone" of the node program: bounding cones.
// Measured by tools/measure_modules, never linked into pxm (docs/program-memory.md).
#include "dsp_kernels/modules/measured_node.hpp"
#include "dsp_kernels/volume.hpp"

namespace pxm::kernels {

template std::optional<Interval<float>> intersect_cone(Node&, const Ray<float>&,
                                                       std::uint32_t) noexcept;
template Vec3<float> cone_normal(Node&, const Ray<float>&, Side, std::uint32_t) noexcept;

}  // namespace pxm::kernels
