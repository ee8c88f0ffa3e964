// Module "flatness" of the node program: flat cells inside lifted singular maps.
// Measured by tools/measure_modules, never linked into pxm (docs/program-memory.md).
#include "dsp_kernels/flatness.hpp"
#include "dsp_kernels/modules/measured_node.hpp"

namespace pxm::kernels {

template void keep_thickness(Node&, const Search<float>&, const Cell<float>&, std::uint32_t,
                             Cell<float>&) noexcept;

}  // namespace pxm::kernels
