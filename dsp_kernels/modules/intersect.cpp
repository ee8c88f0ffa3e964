// Module "intersect" of the node program: the search for the first cell along a ray (Alg. 12.4).
// Measured by tools/measure_modules, never linked into pxm (docs/program-memory.md).
#include "dsp_kernels/first_cell.hpp"
#include "dsp_kernels/modules/measured_node.hpp"

namespace pxm::kernels {

template void push_objects(Node&, const Search<float>&, Heap<Node>&, SearchCounts&) noexcept;
template void count_heap(const Heap<Node>&, SearchCounts&) noexcept;
template void push_children(Node&, const Search<float>&, const Cell<float>&, Heap<Node>&,
                            SearchCounts&) noexcept;
template SearchResult<float> intersect(Node&, const Search<float>&, Heap<Node>&,
                                       SearchCounts&) noexcept;

template SearchResult<float> first_cell(Node&, const Search<float>&, Heap<Node>&,
                                        SearchCounts&) noexcept;

}  // namespace pxm::kernels
