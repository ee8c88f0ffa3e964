// Walks a word that the wide engine found down the hierarchy, by the clear kernels in double: the
// pixel gets the cell's key and the colour that the definition gives it, or, if rounding led the
// search astray, nothing (docs/design.md, decision 4).
#pragma once

#include <optional>
#include <vector>

#include "dsp_kernels/pixel_program.hpp"
#include "host/render/native_node.hpp"

namespace pxm::host::wide {

/// The terminal cell that the ray meets on the way along a word: the definition may end it sooner.
template <class Node, class Real = typename Node::Real>
[[nodiscard]] std::optional<kernels::Cell<Real>> walk(Node& node,
                                                      const kernels::Search<Real>& search,
                                                      std::uint32_t object,
                                                      const std::vector<int>& word) {
    kernels::Cell<Real> cell;
    kernels::outermost_cell(node, search, object, cell);
    if (!kernels::meet(node, cell, Real(0), from_double<Real>(1e30))) return std::nullopt;
    for (const int symbol : word) {
        const kernels::Ending end = kernels::ending(node, search, cell);
        if (end == kernels::Ending::terminal) return cell;
        if (end == kernels::Ending::word_full) return std::nullopt;
        const std::uint32_t map =
            kernels::map_from(node, cell.follow_set, static_cast<std::uint32_t>(symbol));
        kernels::Cell<Real> child;
        kernels::child_cell(node, search, cell, map, child);
        if (!kernels::meet(node, child, cell.key, cell.exit)) return std::nullopt;
        if (kernels::is_polar(node, object)) kernels::complete_child(node, cell, map, child);
        kernels::copy_cell(cell, child);
    }
    if (kernels::ending(node, search, cell) != kernels::Ending::terminal) return std::nullopt;
    return cell;
}

}  // namespace pxm::host::wide
