// A listener to the search, for `--pixel`: nodes that are not watched compile it to nothing.
#pragma once

#include "dsp_kernels/cell.hpp"

namespace pxm::kernels {

/// What happened to a cell.
enum class CellEvent { met, missed, expanded, terminal, capped, dropped, restarted };

template <class Node>
void watch(Node& node, CellEvent event, const Cell<typename Node::Real>& cell) noexcept {
    if constexpr (Node::watched) node.watch(event, cell);
}

}  // namespace pxm::kernels
