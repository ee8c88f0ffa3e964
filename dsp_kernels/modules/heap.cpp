// Module "heap" of the node program: the bounded heap of cells (Def. 12.1).
// Measured by tools/measure_modules, never linked into pxm (docs/program-memory.md).
#include "dsp_kernels/heap.hpp"
#include "dsp_kernels/modules/measured_node.hpp"

namespace pxm::kernels {

template bool before(Node&, const Cell<float>&, const Cell<float>&) noexcept;
template std::uint32_t cell_words(const Cell<float>&) noexcept;
template void copy_cell(Cell<float>&, const Cell<float>&) noexcept;
template void move_cell(Node&, Cell<float>&, const Cell<float>&) noexcept;
template Heap<Node>::Heap(Node&) noexcept;
template void Heap<Node>::push(const Cell<float>&) noexcept;
template void Heap<Node>::pop(Cell<float>&) noexcept;
template void Heap<Node>::keep(std::uint32_t, const Cell<float>&) noexcept;
template void Heap<Node>::fetch(std::uint32_t, Cell<float>&) noexcept;

}  // namespace pxm::kernels
