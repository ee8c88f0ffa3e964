// Module "texture_inclusion" of the node program: flat attractors as textures (Alg. 7.2).
// Measured by tools/measure_modules, never linked into pxm (docs/program-memory.md).
#include "dsp_kernels/texture_inclusion.hpp"
#include "dsp_kernels/modules/measured_node.hpp"

namespace pxm::kernels {

template Vec2<float> times(Node&, const Vec2<float>&, const Vec2<float>*) noexcept;
template float largest_stretch(Node&, const PointCell<float>&) noexcept;
template bool outermost_point_cell(Node&, std::uint32_t, const Spot<float>&, PointCell<float>&,
                                   ToSpot<float>&) noexcept;
template Vec3<float> inclusion_color(Node&, std::uint32_t, const Spot<float>&) noexcept;

}  // namespace pxm::kernels
