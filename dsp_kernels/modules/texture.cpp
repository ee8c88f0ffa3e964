// Module "texture" of the node program: the textures of a plane, in spots along a pixel's
// footprint. Measured by tools/measure_modules, never linked into pxm (docs/program-memory.md).
#include "dsp_kernels/texture.hpp"
#include "dsp_kernels/modules/measured_node.hpp"

namespace pxm::kernels {

template Footprint<float> footprint(Node&, const Vec3<float>&, const Vec3<float>&, float) noexcept;
template Place<float> place_of(Node&, float) noexcept;
template Vec3<float> texture_color(Node&, std::uint32_t, const Spot<float>&) noexcept;
template Vec3<float> layer_color(Node&, std::uint32_t, const Vec3<float>&,
                                 const Footprint<float>&) noexcept;

}  // namespace pxm::kernels
