// Module "shade" of the node program: hierarchical shading (Ch. 17).
// Measured by tools/measure_modules, never linked into pxm (docs/program-memory.md).
#include "dsp_kernels/shade.hpp"
#include "dsp_kernels/modules/measured_node.hpp"

namespace pxm::kernels {

template Surface<float> surface_at(Node&, const Sighting<float>&, ShadingMode) noexcept;
template Vec3<float> volume_normal(Node&, const Ray<float>&, float, Side, std::uint32_t) noexcept;
template float outermost_diameter(Node&, const Search<float>&, std::uint32_t) noexcept;
template void PathSum<Node>::add(Node&, const Vec3<float>&, float) noexcept;
template Vec3<float> blend(Node&, const Vec3<float>&, std::uint32_t) noexcept;
template Vec3<float> cell_normal(Node&, const Cell<float>&, float, Side,
                                 const Linear<float>&) noexcept;

}  // namespace pxm::kernels
