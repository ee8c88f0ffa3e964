// Module "plane" of the node program: planes: where a ray meets the nearest, and what it looks
// like. Measured by tools/measure_modules, never linked into pxm (docs/program-memory.md).
#include "dsp_kernels/plane.hpp"
#include "dsp_kernels/modules/measured_node.hpp"

namespace pxm::kernels {

template bool nearest_plane(Node&, const Ray<float>&, float, float, PlaneHit<float>&) noexcept;
template Surface<float> plane_surface(Node&, const Ray<float>&, float,
                                      const PlaneHit<float>&) noexcept;

}  // namespace pxm::kernels
