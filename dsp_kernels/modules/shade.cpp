// Module "shade" of the node program: hierarchical shading (Ch. 17).
// Measured by tools/measure_modules, never linked into pxm (docs/program-memory.md).
#include "dsp_kernels/shade.hpp"
#include "dsp_kernels/modules/measured_node.hpp"

namespace pxm::kernels {

template Surface<float> surface_at(Node&, const Search<float>&, const Cell<float>&,
                                   ShadingMode) noexcept;
template Vec3<float> volume_normal(Node&, const Ray<float>&, float, Side, std::uint32_t) noexcept;

}  // namespace pxm::kernels
