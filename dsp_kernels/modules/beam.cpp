// Module "beam" of the node program: local covers by area, one search for all places in a pixel.
// Measured by tools/measure_modules, never linked into pxm (docs/program-memory.md).
#include "dsp_kernels/beam.hpp"
#include "dsp_kernels/modules/measured_node.hpp"

namespace pxm::kernels {

template void Beam<Node>::look(Heap<Node>&, SearchCounts&, SightList<float>&) noexcept;
template Ray<float> Beam<Node>::ray_through(const Vec3<float>&) noexcept;

}  // namespace pxm::kernels
