// Module "texture_image" of the node program: pictures as textures.
// Measured by tools/measure_modules, never linked into pxm (docs/program-memory.md).
#include "dsp_kernels/texture_image.hpp"
#include "dsp_kernels/modules/measured_node.hpp"

namespace pxm::kernels {

template Vec3<float> texel(Node&, std::uint32_t) noexcept;
template Vec3<float> image_level(Node&, std::uint32_t, float, float) noexcept;
template Vec3<float> image_color(Node&, std::uint32_t, const Spot<float>&) noexcept;

}  // namespace pxm::kernels
