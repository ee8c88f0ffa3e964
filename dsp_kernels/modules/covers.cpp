// Module "covers" of the node program: local covers and translucent volumes (Ch. 18).
// Measured by tools/measure_modules, never linked into pxm (docs/program-memory.md).
#include "dsp_kernels/modules/measured_node.hpp"
#include "dsp_kernels/trace.hpp"

namespace pxm::kernels {

template Ray<float> shrunk_for_covers(Node&, const Search<float>&, const Cell<float>&) noexcept;
template void covers_along(Node&, const Search<float>&, const Cell<float>*, Heap<Node>&,
                           SearchCounts&, const CollectCovers<Node>&) noexcept;
template void covers_along(Node&, const Search<float>&, const Cell<float>*, Heap<Node>&,
                           SearchCounts&, const DimLight<Node>&) noexcept;

}  // namespace pxm::kernels
