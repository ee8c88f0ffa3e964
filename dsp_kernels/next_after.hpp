// The search that needs no heap: a depth-first descent in word order that finds the smallest cell
// that shows and is not before a given cell D. It finishes the rays whose heap overflowed;
// everything before D was searched by then. Only the word of the path is kept, and in the heap's
// slots cells on it; where the path is longer than the heap, cells are made again from the word.
// Node code: no allocation, no exceptions.
#pragma once

#include "dsp_kernels/descend.hpp"
#include "dsp_kernels/heap.hpp"
#include "dsp_kernels/search_result.hpp"
#include "dsp_kernels/watch.hpp"

namespace pxm::kernels {

/// Where a search begins: with a cell itself, or with the next one.
enum class From { cell, next };

/// The rule of solid objects: terminal cells show, and nothing else does.
struct SolidRule {
    /// Opacity 1 of a terminal cell, 0 of all others.
    template <NodeLike Node, class Real = typename Node::Real>
    [[nodiscard]] Shown<Real> operator()(Node& node, const Search<Real>&, const Cell<Real>&,
                                         Ending end) const noexcept {
        node.tally(Operation::integer, 1);
        return {end == Ending::terminal ? Real(1) : Real(0), 0};
    }
};

/// The path of cells from an object's outermost cell down to the one being looked at, in the heap's
/// slots: the first quarter of them holds the first levels, the others the last ones, in turn. What
/// lies between is made again from the word when the path comes back to it, as many levels at once
/// as there are slots: a path may be a hundred times as long as the heap.
template <NodeLike Node>
class CellPath {
  public:
    using Real = typename Node::Real;  // of the node

    /// An empty path; `search` and `heap` must outlive it.
    CellPath(Node& node, const Search<Real>& search, Heap<Node>& heap) noexcept
        : node_(node),
          search_(search),
          heap_(heap),
          first_(heap.capacity() / 4),
          recent_(heap.capacity() - first_) {}

    /// The cell at the end of the path.
    [[nodiscard]] Cell<Real>& last() noexcept { return last_; }

    /// Starts at an object; false if the ray does not meet it.
    [[nodiscard]] bool start(std::uint32_t object) noexcept {
        lowest_ = first_;
        outermost_cell(node_, search_, object, last_);
        return meet(node_, search_, last_, search_.start, search_.end);
    }

    /// Goes down to the map; if the ray does not meet its cell, stays where it is and returns
    /// false.
    [[nodiscard]] bool down(std::uint32_t map) noexcept {
        Cell<Real> child;
        child_cell(node_, search_, last_, map, child);
        if (!meet(node_, search_, child, last_.key, last_.exit)) return false;
        if (is_polar(node_, last_.object)) complete_child(node_, last_, map, child);
        keep_last();
        move_cell(node_, last_, child);
        return true;
    }

    /// Goes up one level and returns the symbol that was left. Precondition: not at an object.
    [[nodiscard]] std::uint32_t up() noexcept {
        node_.tally(Operation::integer, 4);
        const std::uint32_t level = last_.level - 1U;
        const std::uint32_t symbol = last_.word.get(level, last_.bits);
        if (level < first_ || lowest_ <= level) {
            heap_.fetch(slot_of(level), last_);
        } else {
            make_again(level);
        }
        return symbol;
    }

  private:
    [[nodiscard]] std::uint32_t slot_of(std::uint32_t level) const noexcept {
        return level < first_ ? level : first_ + (level - first_) % recent_;
    }
    void keep_last() noexcept {
        const std::uint32_t level = last_.level;
        heap_.keep(slot_of(level), last_);
        if (level < first_) return;
        if (level < lowest_) lowest_ = level;
        if (level - lowest_ == recent_) ++lowest_;  // it was in the same slot
    }

    /// Walks down again to `level` along the word of the last cell. The same steps give the same
    /// cells.
    void make_again(std::uint32_t level) noexcept {
        Cell<Real> longer;
        move_cell(node_, longer, last_);
        lowest_ = first_;
        if (first_ == 0) {
            (void)start(longer.object);
        } else {
            heap_.fetch(first_ - 1, last_);
        }
        while (last_.level < level) {
            node_.tally(Operation::loop_turn, 1);
            node_.tally(Operation::integer, 3);
            const std::uint32_t symbol = longer.word.get(last_.level, longer.bits);
            const std::uint32_t map = map_from(node_, last_.follow_set, symbol);
            (void)down(map);
        }
    }

    Node& node_;
    const Search<Real>& search_;
    Heap<Node>& heap_;
    std::uint32_t first_;       // levels that stay in their slots
    std::uint32_t recent_;      // slots for the last levels
    std::uint32_t lowest_ = 0;  // of the levels from first_ on, those from here on are kept
    Cell<Real> last_;
};

/// What next_after looks for: the smallest cell that shows by `rule` and is not before `bound`.
template <class Real, class Rule>
struct Sought {
    const Cell<Real>& bound;     // the cell that the search begins with
    From from;                   // with itself, or behind it
    Rule rule;                   // what shows
    std::uint64_t most_volumes;  // the cap on cells, as a count of volumes tested
};

/// Looks at a cell where the path arrived. `result` holds the best cell so far and is replaced by
/// a smaller one. Says whether to look inside.
template <NodeLike Node, class Rule, class Real = typename Node::Real>
[[nodiscard]] Ending look_at(Node& node, const Search<Real>& search,
                             const Sought<Real, Rule>& sought, const Cell<Real>& cell,
                             SearchResult<Real>& result) noexcept {
    node.tally(Operation::compare_branch, 2);
    // Cells come in word order, so a cell is smaller than the best one only by its key.
    const bool hopeless = cell.exit < sought.bound.key ||
                          (result.outcome == Outcome::hit && !(cell.key < result.cell.key));
    if (hopeless) return Ending::terminal;
    const Ending end = ending(node, search, cell);
    if (end == Ending::word_full) return end;
    const bool early = sought.from == From::cell ? before(node, cell, sought.bound)
                                                 : !before(node, sought.bound, cell);
    if (early) return end;
    const Shown<Real> shown = sought.rule(node, search, cell, end);
    node.tally(Operation::compare_branch, 1);
    if (Real(0) < shown.opacity) {
        result.outcome = Outcome::hit;
        result.shown = shown;
        move_cell(node, result.cell, cell);
    }
    return end;
}

/// Searches one object. False if the cap on cells or the longest word was reached.
template <NodeLike Node, class Rule, class Real = typename Node::Real>
[[nodiscard]] bool next_after_in(Node& node, const Search<Real>& search,
                                 const Sought<Real, Rule>& sought, CellPath<Node>& path,
                                 SearchResult<Real>& result, SearchCounts& counts) noexcept {
    constexpr std::uint32_t nothing_inside = 0xFFFF'FFFF;
    std::uint32_t symbol = 0;  // the next symbol to try inside the last cell
    bool arrived = true;       // at a cell not looked at before
    while (true) {
        node.tally(Operation::loop_turn, 1);
        Cell<Real>& cell = path.last();
        node.tally(Operation::integer, 3);
        if (arrived) {
            const Ending end = look_at(node, search, sought, cell, result);
            if (end == Ending::word_full || counts.volumes_tested >= sought.most_volumes) {
                return false;
            }
            symbol = end == Ending::terminal ? nothing_inside : 0;
            arrived = false;
        }
        const std::uint32_t map =
            symbol == nothing_inside ? 0 : map_from(node, cell.follow_set, symbol);
        if (map == 0) {
            if (cell.level == 0) return true;
            symbol = path.up() + 1;
            continue;
        }
        using Map = MapRecord<real_words<Real>>;
        symbol = node.shape_word(map + Map::symbol) + 1;
        ++counts.volumes_tested;
        arrived = path.down(map);
    }
}

/// The smallest cell that shows by `rule`, from `bound` on, or a miss; capped if the cap on cells
/// was reached. `bound` must not lie in the heap's slots: they hold the path.
template <NodeLike Node, class Rule, class Real = typename Node::Real>
void next_after(Node& node, const Search<Real>& search, Heap<Node>& heap,
                const Sought<Real, Rule>& sought, SearchResult<Real>& result,
                SearchCounts& counts) noexcept {
    using Header = HeaderRecord<real_words<Real>>;
    using Object = ObjectRecord<real_words<Real>>;
    node.tally(Operation::call, 1);
    CellPath<Node> path(node, search, heap);
    result.outcome = Outcome::miss;
    std::uint32_t object = node.shape_word(Header::objects);
    for (std::uint32_t left = node.shape_word(Header::object_count); left > 0; --left) {
        node.tally(Operation::loop_turn, 1);
        ++counts.volumes_tested;
        if (path.start(object) && !next_after_in(node, search, sought, path, result, counts)) {
            if (result.outcome == Outcome::miss) {
                move_cell(node, result.cell, sought.bound);
                result.shown = {Real(1), 0};
            }
            result.outcome = Outcome::capped;
            return;
        }
        object += Object::words;
    }
}

}  // namespace pxm::kernels
