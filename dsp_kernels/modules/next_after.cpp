// Module "next_after" of the node program: the search that finishes the rays whose heap overflowed.
// Measured by tools/measure_modules, never linked into pxm (docs/program-memory.md).
#include "dsp_kernels/next_after.hpp"
#include "dsp_kernels/modules/measured_node.hpp"

namespace pxm::kernels {

template void next_after(Node&, const Search<float>&, Heap<Node>&, SearchResult<float>&,
                         SearchCounts&) noexcept;

}  // namespace pxm::kernels
