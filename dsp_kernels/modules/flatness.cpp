// Module "flatness" of the node program: flat cells inside lifted singular maps.
// Measured by tools/measure_modules, never linked into pxm (docs/program-memory.md).
#include "dsp_kernels/descend.hpp"
#include "dsp_kernels/modules/measured_node.hpp"

namespace pxm::kernels {

template void limit_flatness(Node&, const Search<float>&, Cell<float>&) noexcept;

}  // namespace pxm::kernels
