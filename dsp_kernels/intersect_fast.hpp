// Fast ray-linear fractal intersection (Ch. 13) for systems of homotheties with bounding spheres: a
// ray is a point among the discs of the projected system, cells are opened depth first. They are
// sorted for every ray by entry, and a hit only ends what lies behind it, so that the result is
// that of Alg. 12.4 whether the images overlap or not (Erratum 10). The cells still to be opened
// lie in the heap's slots; a ray that needs more goes back to Alg. 12.4, which needs none. Node
// code: no allocation, no exceptions, at most heap-capacity cells.
#pragma once

#include "dsp_kernels/intersect.hpp"
#include "dsp_kernels/project.hpp"

namespace pxm::kernels {

/// The cells still to be opened, in the slots of the idle heap; the order of their numbers lies in
/// fast memory. The last group pushed is on top, in it the cell with the smallest (key, symbol).
template <NodeLike Node>
class ProjectedStack {
  public:
    using Real = typename Node::Real;   // of the node
    using Entry = ProjectedCell<Real>;  // what it holds

    /// Lays the stack over the node's memories.
    explicit ProjectedStack(Node& node) noexcept
        : node_(node),
          order_(node.heap_order()),
          slots_(node.template heap_records<Entry>()),
          capacity_(static_cast<std::uint32_t>(node.heap_capacity())) {}

    [[nodiscard]] bool empty() const noexcept { return size_ == 0; }  // whether no cell is on it
    /// The most cells that it held.
    [[nodiscard]] std::uint32_t peak() const noexcept { return peak_; }
    /// Whether no other has room.
    [[nodiscard]] bool full() const noexcept { return size_ == capacity_; }

    /// What is pushed from now on is one group.
    void start_group() noexcept { group_ = size_; }
    /// Precondition: not full.
    void push(const Entry& cell) noexcept {
        node_.tally(Operation::call, 1);
        std::uint32_t place = size_++;
        if (peak_ < size_) peak_ = size_;
        const std::uint32_t slot = order_[place];
        write(slot, cell);
        while (place > group_ && !comes_before(cell, slots_[order_[place - 1]])) {
            node_.tally(Operation::loop_turn, 1);
            node_.tally(Operation::integer, 2);
            order_[place] = order_[place - 1];
            --place;
        }
        order_[place] = slot;
    }
    /// Removes the top. Precondition: not empty.
    void pop(Entry& cell) noexcept {
        node_.tally(Operation::call, 1);
        node_.tally(Operation::heap_scattered, 1);
        node_.tally(Operation::heap_sequential, words - 1);
        node_.tally(Operation::integer, words + 2);
        cell = slots_[order_[--size_]];
    }

  private:
    static constexpr std::uint32_t words = sizeof(Entry) / 4;

    void write(std::uint32_t slot, const Entry& cell) noexcept {
        node_.tally(Operation::heap_scattered, 1);
        node_.tally(Operation::heap_sequential, words - 1);
        node_.tally(Operation::integer, words);
        slots_[slot] = cell;
    }
    [[nodiscard]] bool comes_before(const Entry& a, const Entry& b) noexcept {
        node_.tally(Operation::heap_scattered, 1);
        node_.tally(Operation::compare_branch, 1);
        if (a.key < b.key) return true;
        if (b.key < a.key) return false;
        node_.tally(Operation::heap_scattered, 1);
        node_.tally(Operation::integer, 1);
        return a.symbol < b.symbol;
    }

    Node& node_;
    std::uint32_t* order_;  // a permutation of the slots, as the heap left it
    Entry* slots_;
    std::uint32_t capacity_;
    std::uint32_t size_ = 0;
    std::uint32_t group_ = 0;
    std::uint32_t peak_ = 0;
};

/// A projected cell as one of Alg. 12.4, without its ray: what shading and the watch ask of it.
template <NodeLike Node, class Real = typename Node::Real>
void as_cell(Node& node, const ProjectedRay<Real>& ray, const ProjectedCell<Real>& cell,
             const CellWord& word, Cell<Real>& result) noexcept {
    using Object = ObjectRecord<real_words<Real>>;
    node.tally(Operation::integer, 9U + CellWord::used(cell.level, ray.bits));
    node.tally(Operation::multiply_add, 1);
    result.key = cell.key;
    result.exit = cell.exit;
    result.constant = ray.constant * cell.scale;
    if (is_polar(node, ray.object)) {
        const Real over = node.shape_real(ray.object + Object::constant);
        node.tally(Operation::divide, 1);
        const Real scale_of_word = result.constant / over;
        result.linear = read_linear(node, ray.object + Object::linear);
        for (Vec3<Real>& row : result.linear.rows) row = scale(node, scale_of_word, row);
    }
    result.object = ray.object;
    result.follow_set = cell.follow_set;
    result.lost_axes = 0;
    result.level = static_cast<std::uint16_t>(cell.level);
    result.bits = ray.bits;
    const std::uint32_t used = CellWord::used(cell.level, ray.bits);
    for (std::uint32_t i = 0; i < used; ++i) result.word.packed[i] = word.packed[i];
}

/// Tells a watched node of a projected cell.
template <NodeLike Node, class Real = typename Node::Real>
void watch_projected(Node& node, CellEvent event, const ProjectedRay<Real>& ray,
                     const ProjectedCell<Real>& cell, CellWord word) noexcept {
    if constexpr (Node::watched) {
        if (cell.level > 0) word.set(cell.level - 1, ray.bits, cell.symbol);
        Cell<Real> told;
        as_cell(node, ray, cell, word, told);
        watch(node, event, told);
    }
}

/// Pushes the cells inside `parent` that the point lies in; false if there is no room for them.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] bool push_projected(Node& node, const ProjectedRay<Real>& ray,
                                  const ProjectedCell<Real>& parent, const CellWord& word,
                                  ProjectedStack<Node>& stack, SearchCounts& counts) noexcept {
    using FollowSet = FollowSetRecord<real_words<Real>>;
    const Vec3<Real> center = read_vector(node, parent.follow_set + FollowSet::center);
    std::uint32_t list = parent.follow_set + FollowSet::maps;
    stack.start_group();
    for (std::uint32_t left = node.shape_word(parent.follow_set + FollowSet::map_count); left > 0;
         --left) {
        node.tally(Operation::loop_turn, 1);
        ProjectedCell<Real> child;
        project_child(node, ray, parent, center, node.shape_word(list++), child);
        ++counts.volumes_tested;
        const bool met = include_point(node, child, parent.key, parent.exit);
        watch_projected(node, met ? CellEvent::met : CellEvent::missed, ray, child, word);
        if (!met) continue;
        if (stack.full()) return false;
        stack.push(child);
        ++counts.heap_pushes;
    }
    return true;
}

/// Whether a cell can hold a smaller (key, object, word) than the best one. Objects are searched in
/// their order, so that at equal keys an earlier one stays.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] bool is_promising(Node& node, const ProjectedRay<Real>& ray,
                                const ProjectedCell<Real>& cell, const CellWord& word,
                                const SearchResult<Real>& best) noexcept {
    node.tally(Operation::integer, 1);
    if (best.outcome == Outcome::miss) return true;
    node.tally(Operation::compare_branch, 1);
    if (cell.key < best.cell.key) return true;
    if (best.cell.key < cell.key || best.cell.object != ray.object) return false;
    node.tally(Operation::integer, 2U + CellWord::used(cell.level, ray.bits));
    return word_before(word, cell.level, best.cell.word, best.cell.level, ray.bits);
}

/// Whether the search of an object came to its end.
enum class FastEnd { searched, capped, no_room };

/// The smallest terminal cell of an object if it is smaller than the one in `best`.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] FastEnd search_object(Node& node, const Search<Real>& search, std::uint32_t object,
                                    std::uint64_t most_volumes, SearchResult<Real>& best,
                                    SearchCounts& counts) noexcept {
    node.tally(Operation::call, 1);
    CellWord word;  // of the cell last opened
    ProjectedCell<Real> cell;
    const ProjectedRay<Real> ray = project_ray(node, search, object, cell);
    ++counts.volumes_tested;
    const bool met = include_point(node, cell, search.start, search.end);
    watch_projected(node, met ? CellEvent::met : CellEvent::missed, ray, cell, word);
    if (!met) return FastEnd::searched;
    ProjectedStack<Node> stack(node);
    stack.push(cell);
    while (!stack.empty()) {
        node.tally(Operation::loop_turn, 1);
        node.tally(Operation::integer, 4);
        stack.pop(cell);
        if (cell.level > 0) word.set(cell.level - 1, ray.bits, cell.symbol);
        if (!is_promising(node, ray, cell, word, best)) continue;
        const Ending end = ending(node, search, ray, cell);
        const bool capped = end == Ending::word_full || counts.volumes_tested >= most_volumes;
        if (end == Ending::terminal || (capped && best.outcome == Outcome::miss)) {
            as_cell(node, ray, cell, word, best.cell);
            best.outcome = Outcome::hit;
        }
        if (capped) return FastEnd::capped;
        if (end == Ending::terminal) continue;
        watch_projected(node, CellEvent::expanded, ray, cell, word);
        if (!push_projected(node, ray, cell, word, stack, counts)) return FastEnd::no_room;
        if (counts.heap_peak < stack.peak()) counts.heap_peak = stack.peak();
    }
    return FastEnd::searched;
}

/// The terminal cell with the smallest (key, object, word) that the ray meets, as intersect() finds
/// it. Preconditions: all maps are homotheties, all volumes spheres. The heap is left in an
/// unspecified state; `counts` is added to.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] SearchResult<Real> intersect_fast(Node& node, const Search<Real>& search,
                                                Heap<Node>& heap, SearchCounts& counts) noexcept {
    using Header = HeaderRecord<real_words<Real>>;
    using Object = ObjectRecord<real_words<Real>>;
    node.tally(Operation::call, 1);
    SearchResult<Real> result;
    const std::uint64_t most_volumes = counts.volumes_tested + search.cell_cap;
    std::uint32_t object = node.shape_word(Header::objects);
    for (std::uint32_t left = node.shape_word(Header::object_count); left > 0; --left) {
        node.tally(Operation::loop_turn, 1);
        const FastEnd end = search_object(node, search, object, most_volumes, result, counts);
        if (end == FastEnd::no_room) return intersect(node, search, heap, counts);
        if (end == FastEnd::capped) {
            result.outcome = Outcome::capped;
            ++counts.capped;
            break;
        }
        object += Object::words;
    }
    if (result.outcome != Outcome::miss) {
        watch(node, result.outcome == Outcome::hit ? CellEvent::terminal : CellEvent::capped,
              result.cell);
    }
    return result;
}

}  // namespace pxm::kernels
