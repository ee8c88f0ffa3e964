// Module "texture_wood" of the node program: woodgrain, and the noise it is made of.
// Measured by tools/measure_modules, never linked into pxm (docs/program-memory.md).
#include "dsp_kernels/texture_wood.hpp"
#include "dsp_kernels/modules/measured_node.hpp"

namespace pxm::kernels {

template std::uint32_t scramble(Node&, std::uint32_t, std::uint32_t, std::uint32_t) noexcept;
template float noise(Node&, float, float, std::uint32_t) noexcept;
template float share_in_stripes(Node&, float, float, float) noexcept;
template float ring_darkness(Node&, float, float) noexcept;
template float board_darkness(Node&, const BoardSpot<float>&) noexcept;
template Vec3<float> wood_color(Node&, std::uint32_t, std::uint32_t, std::uint32_t,
                                const Spot<float>&) noexcept;

}  // namespace pxm::kernels
