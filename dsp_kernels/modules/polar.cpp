// Module "polar" of the node program: Lipschitz constants by polar decomposition (Sec. 16.2).
// Measured by tools/measure_modules, never linked into pxm (docs/program-memory.md).
#include "dsp_kernels/descend.hpp"
#include "dsp_kernels/modules/measured_node.hpp"

namespace pxm::kernels {

template float largest_singular_value(Node&, const Linear<float>&) noexcept;
template void complete_child(Node&, const Cell<float>&, std::uint32_t, Cell<float>&) noexcept;

}  // namespace pxm::kernels
