// Ray-linear fractal intersection: the first cell that a ray meets among the attractors of a scene.
// Alg. 12.4 with Errata 2 and 3, and a heap that may overflow. There is one bounding volume per
// follow set and many instanced rays: a ray goes back through inverse maps until the cell it meets
// is no larger than a pixel. Node code: no allocation, no exceptions, at most heap-capacity cells.
#pragma once

#include "dsp_kernels/descend.hpp"
#include "dsp_kernels/heap.hpp"
#include "dsp_kernels/known.hpp"
#include "dsp_kernels/next_after.hpp"
#include "dsp_kernels/search_result.hpp"
#include "dsp_kernels/watch.hpp"

namespace pxm::kernels {

/// Step 1: the outermost cells of all objects that the ray meets.
template <NodeLike Node, class Real = typename Node::Real>
void push_objects(Node& node, const Search<Real>& search, Heap<Node>& heap,
                  SearchCounts& counts) noexcept {
    using Header = HeaderRecord<real_words<Real>>;
    using Object = ObjectRecord<real_words<Real>>;
    std::uint32_t object = node.shape_word(Header::objects);
    for (std::uint32_t left = node.shape_word(Header::object_count); left > 0; --left) {
        node.tally(Operation::loop_turn, 1);
        Cell<Real> cell;
        outermost_cell(node, search, object, cell);
        ++counts.volumes_tested;
        const bool met = meet(node, search, cell, search.start, search.end);
        watch(node, met ? CellEvent::met : CellEvent::missed, cell);
        if (met) heap.push(cell);
        object += Object::words;
    }
}

/// Step 2.4: the cells of all valid maps inside `parent` that the ray meets.
template <NodeLike Node, class Real = typename Node::Real>
void push_children(Node& node, const Search<Real>& search, const Cell<Real>& parent,
                   Heap<Node>& heap, SearchCounts& counts) noexcept {
    using FollowSet = FollowSetRecord<real_words<Real>>;
    const bool polar = is_polar(node, parent.object);
    std::uint32_t list = parent.follow_set + FollowSet::maps;
    for (std::uint32_t left = node.shape_word(parent.follow_set + FollowSet::map_count); left > 0;
         --left) {
        node.tally(Operation::loop_turn, 1);
        const std::uint32_t map = node.shape_word(list++);
        Cell<Real> child;
        child_cell(node, search, parent, map, child);
        ++counts.volumes_tested;
        const bool met = meet(node, search, child, parent.key, parent.exit);
        watch(node, met ? CellEvent::met : CellEvent::missed, child);
        if (!met) continue;
        if (polar) complete_child(node, parent, map, child);
        heap.push(child);
        ++counts.heap_pushes;
    }
}

/// Adds what a search did with its heap.
template <NodeLike Node>
void count_heap(const Heap<Node>& heap, SearchCounts& counts) noexcept {
    if (counts.heap_peak < heap.peak()) counts.heap_peak = heap.peak();
    if (heap.overflowed()) ++counts.heap_overflows;
}

/// The terminal cell with the smallest (key, object, word) that the ray meets. The heap is left in
/// an unspecified state; `counts` is added to.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] SearchResult<Real> intersect(Node& node, const Search<Real>& search, Heap<Node>& heap,
                                           SearchCounts& counts) noexcept {
    node.tally(Operation::call, 1);
    SearchResult<Real> result;
    const std::uint64_t most_volumes = counts.volumes_tested + search.cell_cap;
    heap.clear();
    forget_known(node);
    push_objects(node, search, heap, counts);
    while (!heap.empty()) {
        node.tally(Operation::loop_turn, 1);
        node.tally(Operation::integer, 3);
        heap.pop(result.cell);
        const Ending end = ending(node, search, result.cell);
        const bool capped = end == Ending::word_full || counts.volumes_tested >= most_volumes;
        if (end == Ending::terminal || capped) {
            result.outcome = end == Ending::terminal ? Outcome::hit : Outcome::capped;
            break;
        }
        if (is_known(node, search, result.cell)) {
            watch(node, CellEvent::known, result.cell);
            continue;
        }
        watch(node, CellEvent::expanded, result.cell);
        push_children(node, search, result.cell, heap, counts);
    }
    count_heap(heap, counts);
    if (result.outcome == Outcome::miss && heap.overflowed()) {
        watch(node, CellEvent::restarted, heap.smallest_dropped());
        ++counts.restarts;
        const Sought<Real, SolidRule> sought{heap.smallest_dropped(), From::cell, SolidRule{},
                                             most_volumes};
        next_after(node, search, heap, sought, result, counts);
    }
    if (result.outcome == Outcome::capped) ++counts.capped;
    if (result.outcome != Outcome::miss) {
        watch(node, result.outcome == Outcome::hit ? CellEvent::terminal : CellEvent::capped,
              result.cell);
    }
    return result;
}

}  // namespace pxm::kernels
