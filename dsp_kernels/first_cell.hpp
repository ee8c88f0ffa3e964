// The first cell along a ray, by the method that the scene block names. Node code: no allocation,
// no exceptions.
#pragma once

#include "dsp_kernels/intersect.hpp"
#include "dsp_kernels/intersect_fast.hpp"

namespace pxm::kernels {

/// The terminal cell with the smallest (key, object, word) that the ray meets. The heap is left in
/// an unspecified state; `counts` is added to.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] SearchResult<Real> first_cell(Node& node, const Search<Real>& search,
                                            Heap<Node>& heap, SearchCounts& counts) noexcept {
    // Not counted: only one of the two is linked into a node's program. Cells are known in the
    // order of Alg. 12.4 alone.
    if (search.method == Method::fast && !knows_cells(node))
        return intersect_fast(node, search, heap, counts);
    return intersect(node, search, heap, counts);
}

}  // namespace pxm::kernels
