// Module "camera" of the node program: eye rays of any projection.
// Measured by tools/measure_modules, never linked into pxm (docs/program-memory.md).
#include "dsp_kernels/camera.hpp"
#include "dsp_kernels/modules/measured_node.hpp"

namespace pxm::kernels {

template Ray<float> eye_ray(Node&, std::uint32_t, std::uint32_t, std::uint32_t) noexcept;

}  // namespace pxm::kernels
