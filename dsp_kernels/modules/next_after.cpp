// Module "next_after" of the node program: the search that finishes the rays whose heap overflowed.
// Measured by tools/measure_modules, never linked into pxm (docs/program-memory.md).
#include "dsp_kernels/next_after.hpp"
#include "dsp_kernels/modules/measured_node.hpp"

namespace pxm::kernels {

template void next_after(Node&, const Search<float>&, Heap<Node>&, const Sought<float, SolidRule>&,
                         SearchResult<float>&, SearchCounts&) noexcept;
template bool CellPath<Node>::start(std::uint32_t) noexcept;
template bool CellPath<Node>::down(std::uint32_t) noexcept;
template std::uint32_t CellPath<Node>::up() noexcept;

}  // namespace pxm::kernels
