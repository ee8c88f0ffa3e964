// Module "descend" of the node program: from an object to its outermost cell, from a cell to those
// inside it. Measured by tools/measure_modules, never linked into pxm (docs/program-memory.md).
#include "dsp_kernels/descend.hpp"
#include "dsp_kernels/modules/measured_node.hpp"

namespace pxm::kernels {

template void approach(Node&, Cell<float>&) noexcept;
template bool meet(Node&, const Search<float>&, Cell<float>&, float, float) noexcept;
template void outermost_cell(Node&, const Search<float>&, std::uint32_t, Cell<float>&) noexcept;
template void child_cell(Node&, const Search<float>&, const Cell<float>&, std::uint32_t,
                         Cell<float>&) noexcept;
template std::uint32_t map_from(Node&, std::uint32_t, std::uint32_t) noexcept;
template Ending ending(Node&, const Search<float>&, const Cell<float>&) noexcept;
template float pixel_at(Node&, const Search<float>&, std::uint32_t, float) noexcept;
template bool at_last_level(Node&, const Cell<float>&) noexcept;
template bool is_polar(Node&, std::uint32_t) noexcept;
template float cell_diameter(Node&, const Cell<float>&) noexcept;
template std::optional<Interval<float>> intersect_volume(Node&, const Ray<float>&,
                                                         std::uint32_t) noexcept;

}  // namespace pxm::kernels
