// A listener to the search, for `--pixel`: nodes that are not watched compile it to nothing.
#pragma once

#include "dsp_kernels/cell.hpp"
#include "dsp_kernels/search.hpp"

namespace pxm::kernels {

/// What happened to a cell.
enum class CellEvent { met, missed, expanded, known, terminal, capped, dropped, restarted };

/// What a ray is for.
enum class RayKind { eye, mirror, light };

/// Tells a node that is watched what happened to a cell.
template <class Node>
void watch(Node& node, CellEvent event, const Cell<typename Node::Real>& cell) noexcept {
    if constexpr (Node::watched) node.watch(event, cell);
}

/// A search whose cells are reported next.
template <class Node, class Real = typename Node::Real>
void watch_ray(Node& node, RayKind kind, const Search<Real>& search) noexcept {
    if constexpr (Node::watched) node.watch_ray(kind, search);
}

}  // namespace pxm::kernels
