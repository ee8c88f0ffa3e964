// Cells that a ray has opened by another word: where cells overlap, many words lead to (nearly) the
// same one, and what lies inside need not be searched twice. The machine's nodes have no memory for
// such a record; a native node that keeps one (host/node_program/known_cells.hpp) is asked, and for
// all others this compiles to nothing.
#pragma once

#include "dsp_kernels/cell.hpp"
#include "dsp_kernels/search.hpp"

namespace pxm::kernels {

/// Forgets the cells of the ray before.
template <NodeLike Node>
void forget_known(Node& node) noexcept {
    if constexpr (requires { node.forget_known(); }) node.forget_known();
}

/// Whether what the ray meets inside the cell was met in one that was opened before. If not, the
/// cell counts as opened. Precondition: cells come in the order (key, object, word).
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] bool is_known(Node& node, const Search<Real>& search,
                            const Cell<Real>& cell) noexcept {
    if constexpr (requires { node.knows(search, cell); }) return node.knows(search, cell);
    return false;
}

/// Whether the node keeps a record of the cells that a ray opens.
template <NodeLike Node>
[[nodiscard]] bool knows_cells(const Node& node) noexcept {
    if constexpr (requires { node.knows_cells(); }) return node.knows_cells();
    return false;
}

}  // namespace pxm::kernels
