// Module "intersect_fast" of the node program: the search for systems of homotheties (Ch. 13).
// Measured by tools/measure_modules, never linked into pxm (docs/program-memory.md).
#include "dsp_kernels/intersect_fast.hpp"
#include "dsp_kernels/modules/measured_node.hpp"

namespace pxm::kernels {

template ProjectedRay<float> project_ray(Node&, const Search<float>&, std::uint32_t,
                                         ProjectedCell<float>&) noexcept;
template bool include_point(Node&, ProjectedCell<float>&, float, float) noexcept;
template void project_child(Node&, const ProjectedRay<float>&, const ProjectedCell<float>&,
                            const Vec3<float>&, std::uint32_t, ProjectedCell<float>&) noexcept;
template Ending ending(Node&, const Search<float>&, const ProjectedRay<float>&,
                       const ProjectedCell<float>&) noexcept;
template void as_cell(Node&, const ProjectedRay<float>&, const ProjectedCell<float>&,
                      const CellWord&, Cell<float>&) noexcept;
template bool push_projected(Node&, const ProjectedRay<float>&, const ProjectedCell<float>&,
                             const CellWord&, ProjectedStack<Node>&, SearchCounts&) noexcept;
template FastEnd search_object(Node&, const Search<float>&, std::uint32_t, std::uint64_t,
                               SearchResult<float>&, SearchCounts&) noexcept;
template SearchResult<float> intersect_fast(Node&, const Search<float>&, Heap<Node>&,
                                            SearchCounts&) noexcept;

}  // namespace pxm::kernels
