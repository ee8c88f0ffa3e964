// Module "orthographic" of the node program: eye rays of an orthographic view.
// Measured by tools/measure_modules, never linked into pxm (docs/program-memory.md).
#include "dsp_kernels/camera.hpp"
#include "dsp_kernels/modules/measured_node.hpp"

namespace pxm::kernels {

template Ray<float> orthographic_ray(Node&, const Vec3<float>&, const Vec3<float>&) noexcept;

}  // namespace pxm::kernels
