// Local covers (Ch. 18): cells near a silhouette that show with partial opacity, and translucent
// objects, whose volumes themselves are shown (Sec. 18.4). A search with covers is Alg. 12.4 that
// does not end at the first cell: it hands over, in their order, all that shows along the ray.
//
// A cell that the ray meets shows once, at its key:
//   a terminal cell (diameter at most tau_min)                fully;
//   a cell of a translucent object                            with the object's opacity;
//   a cell none of whose children the ray meets (Def. 18.2)   by its diameter (Eq. 18.9).
// A map may jump over the bandwidth (Sec. 18.3): then volumes are interpolated between the parent's
// and the child's by scaling the child's about its centre. The one that just meets the ray is the
// local cover, and its diameter gives the opacity: no edge is all or nothing.
// Node code: no allocation, no exceptions.
#pragma once

#include "dsp_kernels/intersect.hpp"

namespace pxm::kernels {

/// Opacity of a local cover by its diameter, in pixels (Eq. 18.9).
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Real cover_opacity(Node& node, Real pixels, Real tau_min, Real tau_max) noexcept {
    node.tally(Operation::compare_branch, 2);
    if (!(pixels < tau_max)) return Real(0);
    if (!(tau_min < pixels)) return Real(1);
    node.tally(Operation::multiply_add, 2);
    node.tally(Operation::divide, 1);
    return (tau_max - pixels) / (tau_max - tau_min);
}

/// What the children of one cell that the ray misses leave of it.
template <class Real>
struct Missed {
    Real diameter;          // of the smallest interpolated volume that the ray meets
    std::uint32_t map = 0;  // the child it belongs to
    bool all = true;        // the ray meets no child
};

/// Looks for children that the ray of a cell passes nearby.
template <NodeLike Node>
class MissedChildren {
  public:
    using Real = typename Node::Real;  // of the node

    /// `diameter` is the cell's, `pixel` the size of a pixel at its key.
    MissedChildren(Node& node, const Search<Real>& search, const Cell<Real>& cell, Real diameter,
                   Real pixel) noexcept
        : node_(node),
          search_(search),
          cell_(cell),
          diameter_(diameter),
          widest_(search.fade * pixel),
          narrowest_(search.detail * pixel) {
        node.tally(Operation::multiply_add, 2);
        missed_.diameter = widest_;
    }

    void met() noexcept { missed_.all = false; }  // tells of a child that the ray meets

    /// A child that the ray does not meet. Precondition: its ray was re-based to its volume.
    void missed(std::uint32_t map, Cell<Real>& child) noexcept {
        using Map = MapRecord<real_words<Real>>;
        node_.tally(Operation::multiply_add, 1);
        node_.tally(Operation::compare_branch, 1);
        if (widest_ < diameter_ * node_.shape_real(map + Map::least)) return;
        node_.tally(Operation::compare_branch, 2);
        if (child.ray.base < search_.start || search_.end < child.ray.base) return;
        if (is_polar(node_, cell_.object)) complete_child(node_, cell_, map, child);
        const Real child_diameter = cell_diameter(node_, child);
        node_.tally(Operation::compare_branch, 1);
        const Real between = growth(child) * child_diameter;
        if (!(between < missed_.diameter)) return;
        missed_.diameter = between;
        missed_.map = map;
        jumps_ = !(narrowest_ < child_diameter) && !(diameter_ < widest_);
    }

    /// What shows of the cell (Eq. 18.9); call it after all children.
    [[nodiscard]] Shown<Real> shown(Real pixel) noexcept {
        node_.tally(Operation::compare_branch, 2);
        if (!has_covers(node_, search_) || (!missed_.all && !jumps_)) return {Real(0), 0};
        Real diameter = missed_.diameter;
        std::uint32_t map = missed_.map;
        if (missed_.all && diameter_ < diameter) {
            diameter = diameter_;
            map = 0;
        }
        node_.tally(Operation::compare_branch, 1);
        if (!(diameter < widest_)) return {Real(0), 0};
        node_.tally(Operation::divide, 1);
        return {cover_opacity(node_, diameter / pixel, search_.detail, search_.fade), map};
    }

  private:
    /// How many times the ball of the child's diameter about its centre must grow to reach the ray,
    /// at least 1.
    [[nodiscard]] Real growth(const Cell<Real>& child) noexcept {
        using FollowSet = FollowSetRecord<real_words<Real>>;
        const Vec3<Real> from_center = subtract(
            node_, child.ray.origin, read_vector(node_, child.follow_set + FollowSet::center));
        node_.tally(Operation::square_root, 1);
        node_.tally(Operation::divide, 1);
        node_.tally(Operation::multiply_add, 1);
        node_.tally(Operation::select, 1);
        const Real distance = square_root(dot(node_, from_center, from_center));
        const Real times =
            (distance + distance) / node_.shape_real(child.follow_set + FollowSet::diameter);
        return times < Real(1) ? Real(1) : times;
    }

    Node& node_;
    const Search<Real>& search_;
    const Cell<Real>& cell_;
    Real diameter_;
    Real widest_;     // tau_max
    Real narrowest_;  // tau_min
    Missed<Real> missed_{};
    bool jumps_ = false;  // from above the bandwidth to below it
};

/// Opacity of the volumes of an object; 1 unless it is translucent.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Real object_opacity(Node& node, std::uint32_t object) noexcept {
    return node.shape_real(object + ObjectRecord<real_words<Real>>::opacity);
}

/// Step 2.4 with covers: calls `met(child)` for the children that the ray meets, and says what
/// shows of the parent.
template <NodeLike Node, class Met, class Real = typename Node::Real>
[[nodiscard]] Shown<Real> cover_children(Node& node, const Search<Real>& search,
                                         const Cell<Real>& parent, Real diameter, Real pixel,
                                         SearchCounts& counts, const Met& met) noexcept {
    using FollowSet = FollowSetRecord<real_words<Real>>;
    const bool polar = is_polar(node, parent.object);
    MissedChildren<Node> missed(node, search, parent, diameter, pixel);
    std::uint32_t list = parent.follow_set + FollowSet::maps;
    for (std::uint32_t left = node.shape_word(parent.follow_set + FollowSet::map_count); left > 0;
         --left) {
        node.tally(Operation::loop_turn, 1);
        const std::uint32_t map = node.shape_word(list++);
        Cell<Real> child;
        child_cell(node, search, parent, map, child);
        ++counts.volumes_tested;
        const bool meets = meet(node, search, child, parent.key, parent.exit);
        watch(node, meets ? CellEvent::met : CellEvent::missed, child);
        if (!meets) {
            missed.missed(map, child);
            continue;
        }
        missed.met();
        if (polar) complete_child(node, parent, map, child);
        met(child);
    }
    return missed.shown(pixel);
}

/// What the heap does with children that the ray meets.
template <NodeLike Node>
struct PushChild {
    Heap<Node>& heap;      // they are pushed to
    SearchCounts& counts;  // of the ray
    /// Pushes a child.
    void operator()(const Cell<typename Node::Real>& child) const noexcept {
        heap.push(child);
        ++counts.heap_pushes;
    }
};

/// The rule of covers for next_after: the children are looked at without going down.
struct CoverRule {
    SearchCounts& counts;  // of the ray

    /// What the cell shows when the search has ended at it so.
    template <NodeLike Node, class Real = typename Node::Real>
    [[nodiscard]] Shown<Real> operator()(Node& node, const Search<Real>& search,
                                         const Cell<Real>& cell, Ending end) const noexcept {
        const Real opacity = object_opacity(node, cell.object);
        node.tally(Operation::compare_branch, 1);
        if (end == Ending::terminal || opacity < Real(1)) return {opacity, 0};
        return cover_children(node, search, cell, cell_diameter(node, cell),
                              pixel_at(node, search, cell.object, cell.key), counts,
                              [](const Cell<Real>&) noexcept {});
    }
};

/// One walk along a ray: what came before it, when it is given up, and who is told of its cells.
template <class Real, class See>
struct CoverWalk {
    const Cell<Real>* after;     // null, or only what comes after that cell is reported
    std::uint64_t most_volumes;  // the cap on cells, as a count of volumes tested
    const See& see;              // takes a cell and what it shows; false: no more is wanted

    /// Reports a cell; false if no more is wanted.
    template <NodeLike Node>
    [[nodiscard]] bool tell(Node& node, const Cell<Real>& cell,
                            const Shown<Real>& shown) const noexcept {
        node.tally(Operation::compare_branch, 1);
        if (!(Real(0) < shown.opacity)) return true;
        if (after != nullptr && !before(node, *after, cell)) return true;
        watch(node, CellEvent::terminal, cell);
        return see(cell, shown);
    }
};

/// The part of a walk that the heap holds. False if no more is wanted.
template <NodeLike Node, class See, class Real = typename Node::Real>
[[nodiscard]] bool walk_heap(Node& node, const Search<Real>& search,
                             const CoverWalk<Real, See>& walk, Heap<Node>& heap, Cell<Real>& cell,
                             SearchCounts& counts) noexcept {
    heap.clear();
    push_objects(node, search, heap, counts);
    while (!heap.empty()) {
        node.tally(Operation::loop_turn, 1);
        node.tally(Operation::integer, 3);
        heap.pop(cell);
        node.tally(Operation::compare_branch, 1);
        if (walk.after != nullptr && cell.exit < walk.after->key) continue;
        const Real diameter = cell_diameter(node, cell);
        const Real pixel = pixel_at(node, search, cell.object, cell.key);
        const Ending end = ending(node, search, cell, diameter, pixel);
        if (end == Ending::word_full || counts.volumes_tested >= walk.most_volumes) {
            ++counts.capped;
            watch(node, CellEvent::capped, cell);
            (void)walk.see(cell, {Real(1), 0});
            return false;
        }
        const Real opacity = object_opacity(node, cell.object);
        const bool translucent = opacity < Real(1);
        node.tally(Operation::compare_branch, 1);
        if ((end == Ending::terminal || translucent) && !walk.tell(node, cell, {opacity, 0})) {
            return false;
        }
        if (end == Ending::terminal) continue;
        watch(node, CellEvent::expanded, cell);
        const auto shown = cover_children(node, search, cell, diameter, pixel, counts,
                                          PushChild<Node>{heap, counts});
        if (!translucent && !walk.tell(node, cell, shown)) return false;
    }
    return true;
}

/// The part of a walk from the first cell on that the heap dropped: one search for each cell.
template <NodeLike Node, class See, class Real = typename Node::Real>
void walk_on(Node& node, const Search<Real>& search, const CoverWalk<Real, See>& walk,
             Heap<Node>& heap, SearchResult<Real>& result, SearchCounts& counts) noexcept {
    ++counts.restarts;
    Cell<Real> bound;
    move_cell(node, bound, heap.smallest_dropped());
    From from = From::cell;
    while (true) {
        node.tally(Operation::loop_turn, 1);
        const Sought<Real, CoverRule> sought{bound, from, {counts}, walk.most_volumes};
        next_after(node, search, heap, sought, result, counts);
        if (result.outcome == Outcome::miss) return;
        if (result.outcome == Outcome::capped) ++counts.capped;
        const bool more = walk.tell(node, result.cell, result.shown);
        if (!more || result.outcome == Outcome::capped) return;
        move_cell(node, bound, result.cell);
        from = From::next;
    }
}

/// Calls `see(cell, shown)` for every cell that shows along the ray, in the order (key, object,
/// word), until it returns false. `after`: null, or only what comes after that cell.
template <NodeLike Node, class See, class Real = typename Node::Real>
void covers_along(Node& node, const Search<Real>& search, const Cell<Real>* after, Heap<Node>& heap,
                  SearchCounts& counts, const See& see) noexcept {
    node.tally(Operation::call, 1);
    const CoverWalk<Real, See> walk{after, counts.volumes_tested + search.cell_cap, see};
    SearchResult<Real> result;
    const bool more = walk_heap(node, search, walk, heap, result.cell, counts);
    count_heap(heap, counts);
    if (more && heap.overflowed()) walk_on(node, search, walk, heap, result, counts);
}

}  // namespace pxm::kernels
