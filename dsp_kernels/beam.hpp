// Local covers by area: one search a pixel that tells which of several places in it each small cell
// covers. Ch. 18 takes the opacity of a cover from its diameter, as if the distance from the ray to
// the surface were all that is known; here it is the share of the places that a cell covers, times
// what its attractor covers of its volume on average, which the host measured.
// Alg. 12.4 for a beam: cells are opened in the order of their entries, unless no place that is
// still open lies behind them. Node code: no allocation, no exceptions.
#pragma once

#include <bit>

#include "dsp_kernels/beam_cell.hpp"
#include "dsp_kernels/heap.hpp"
#include "dsp_kernels/intersect.hpp"
#include "dsp_kernels/sight_list.hpp"

namespace pxm::kernels {

/// A beam: the rays through all places of a pixel.
template <NodeLike Node>
class Beam {
  public:
    using Real = typename Node::Real;               // of the node
    using Header = HeaderRecord<real_words<Real>>;  // the scene block's header
    using Record = BeamRecord<real_words<Real>>;    // what the host says of the places

    /// Of the search's ray.
    Beam(Node& node, const Search<Real>& search) noexcept
        : node_(node),
          search_(search),
          frame_(beam_frame(node, search.ray.direction)),
          first_(node.shape_word(Header::samples)),
          record_(first_ + 2 * real_words<Real>),
          count_(node.shape_word(record_ + Record::count)),
          table_(record_ + Record::columns + 2 * (count_ + 1)),
          per_pixel_(from_double<Real>(count_)),
          share_(reciprocal(per_pixel_)),
          open_(~std::uint32_t{0} >> (32 - count_)) {
        node.tally(Operation::to_float, 1);
        node.tally(Operation::reciprocal, 1);
        node.tally(Operation::integer, 8U + count_);
        for (std::uint32_t i = 0; i < count_; ++i) left_[i] = Real(1);
    }

    /// Finds what shows. The heap is left in an unspecified state.
    void look(Heap<Node>& heap, SearchCounts& counts, SightList<Real>& seen) noexcept {
        node_.tally(Operation::call, 1);
        const std::uint64_t most_volumes =
            counts.volumes_tested + search_.cell_cap / searches_a_cap;
        heap.clear();
        push_outermost(heap, counts);
        Cell<Real> cell;
        while (!heap.empty() && open_ != 0) {
            node_.tally(Operation::loop_turn, 1);
            node_.tally(Operation::integer, 3);
            node_.tally(Operation::compare_branch, 1);
            if (counts.volumes_tested >= most_volumes) {
                is_complete_ = false;
                return;
            }
            heap.pop(cell);
            const Vec3<Real> center = center_in_beam(node_, cell);
            const std::uint32_t asked =
                places_around(cell, center, reach_in_beam(node_, cell)) & open_;
            if (asked == 0) continue;
            const Ending end = ending(node_, search_, cell);
            if (end == Ending::word_full) {
                ++counts.capped;
                show(cell, open_, Real(1), seen);
                return;
            }
            if (end == Ending::terminal) {
                show(cell, places_inside(cell, center, asked), coverage(cell), seen);
                continue;
            }
            push_inner(cell, heap, counts);
        }
        is_complete_ = !heap.overflowed();
    }

    /// Whether look() has seen all places. A heap may have been too small, or cells too many, as
    /// long thin ones are; then open places are left to rays, which meet fewer of them.
    [[nodiscard]] bool is_complete() const noexcept { return is_complete_; }
    /// In a pixel, at most 32.
    [[nodiscard]] std::uint32_t places() const noexcept { return count_; }
    /// A place's part of the pixel.
    [[nodiscard]] Real share_of_place() const noexcept { return share_; }
    /// A place from the first one, in pixels.
    [[nodiscard]] Vec3<Real> place(std::uint32_t i) noexcept {
        node_.tally(Operation::multiply_add, 2);
        const std::uint32_t at = table_ + i * 2 * real_words<Real>;
        return {
            node_.shape_real(at) - node_.shape_real(first_),
            node_.shape_real(at + real_words<Real>) - node_.shape_real(first_ + real_words<Real>),
            Real(0)};
    }
    /// Of a place: what is left of it, from 1 down to 0.
    [[nodiscard]] Real left(std::uint32_t place) const noexcept { return left_[place]; }
    /// The mean of what is left.
    [[nodiscard]] Real left() noexcept {
        Real sum = Real(0);
        node_.tally(Operation::multiply_add, 1U + count_);
        for (std::uint32_t i = 0; i < count_; ++i) sum = sum + left_[i];
        return sum * share_;
    }
    /// The ray through a place, given from the first one in pixels.
    [[nodiscard]] Ray<Real> ray_through(const Vec3<Real>& place) noexcept {
        const Vec3<Real> aside = transform_direction(node_, place, frame_);
        Ray<Real> ray = search_.ray;
        ray.origin = add_scaled(node_, ray.origin, search_.pixel.at_origin, aside);
        ray.direction =
            normalize(node_, add_scaled(node_, ray.direction, search_.pixel.growth, aside));
        return ray;
    }

  private:
    void push_outermost(Heap<Node>& heap, SearchCounts& counts) noexcept {
        std::uint32_t object = node_.shape_word(Header::objects);
        for (std::uint32_t left = node_.shape_word(Header::object_count); left > 0; --left) {
            node_.tally(Operation::loop_turn, 1);
            Cell<Real> cell;
            outermost_beam_cell(node_, search_.ray.origin, frame_, object, cell);
            ++counts.volumes_tested;
            if (meet(cell, search_.start)) heap.push(cell);
            object += ObjectRecord<real_words<Real>>::words;
        }
    }

    void push_inner(const Cell<Real>& parent, Heap<Node>& heap, SearchCounts& counts) noexcept {
        using FollowSet = FollowSetRecord<real_words<Real>>;
        std::uint32_t list = parent.follow_set + FollowSet::maps;
        for (std::uint32_t left = node_.shape_word(parent.follow_set + FollowSet::map_count);
             left > 0; --left) {
            node_.tally(Operation::loop_turn, 1);
            const std::uint32_t map = node_.shape_word(list++);
            Cell<Real> child;
            beam_child(node_, parent, map, child);
            ++counts.volumes_tested;
            if (!meet(child, parent.key)) continue;
            extend_word(node_, parent, map, child);
            heap.push(child);
            ++counts.heap_pushes;
        }
    }

    /// Sets the part of the beam that the cell lies in. False if no open place is behind it.
    [[nodiscard]] bool meet(Cell<Real>& cell, Real from) noexcept {
        const Vec3<Real> center = center_in_beam(node_, cell);
        const Vec3<Real> reach = reach_in_beam(node_, cell);
        node_.tally(Operation::multiply_add, 2);
        node_.tally(Operation::select, 1);
        node_.tally(Operation::compare_branch, 2);
        cell.key = center.z - reach.z;
        cell.exit = center.z + reach.z;
        if (cell.key < from) cell.key = from;
        if (cell.exit < cell.key || search_.end < cell.key) return false;
        return (places_around(cell, center, reach) & open_) != 0;
    }

    /// The places in the rectangle around a cell, wherever in it their rays pass.
    [[nodiscard]] std::uint32_t places_around(const Cell<Real>& cell, const Vec3<Real>& center,
                                              const Vec3<Real>& reach) noexcept {
        using Object = ObjectRecord<real_words<Real>>;
        node_.tally(Operation::divide, 2);
        node_.tally(Operation::multiply_add, 9);
        node_.tally(Operation::integer, 12);
        const Real near = per_pixel_ / pixel_at(node_, search_, cell.object, cell.key);
        const Real far = per_pixel_ / pixel_at(node_, search_, cell.object, cell.exit);
        const Real rounding =
            from_double<Real>(0.5) * node_.shape_real(cell.object + Object::smallest_pixel);
        const auto between = [&](Real middle, Real half, std::uint32_t first,
                                 std::uint32_t before) {
            node_.tally(Operation::select, 2);
            const Real low = middle - half - rounding;
            const Real high = middle + half + rounding;
            const Real from = low * (low < Real(0) ? near : far);
            const Real to = high * (high < Real(0) ? far : near);
            return node_.shape_word(before + columns_before(to, first)) &
                   ~node_.shape_word(before + columns_before(from, first));
        };
        const std::uint32_t columns = record_ + Record::columns;
        return between(center.x, reach.x, node_.shape_word(record_ + Record::first_column),
                       columns) &
               between(center.y, reach.y, node_.shape_word(record_ + Record::first_row),
                       columns + count_ + 1);
    }

    /// How many columns have their middle before x, which is given in columns from the middle of
    /// the first place's.
    [[nodiscard]] std::uint32_t columns_before(Real x, std::uint32_t first) noexcept {
        node_.tally(Operation::compare_branch, 2);
        if (!(-per_pixel_ < x)) return 0;
        if (!(x < per_pixel_)) return count_;
        const int before = static_cast<int>(first) - floor_integer(-x);
        if (before < 0) return 0;
        const auto count = static_cast<std::uint32_t>(before);
        return count_ < count ? count_ : count;
    }

    /// Those of the places asked for whose rays meet the cell's volume itself.
    [[nodiscard]] std::uint32_t places_inside(const Cell<Real>& cell, const Vec3<Real>& center,
                                              std::uint32_t asked) noexcept {
        const CellInverse<Real> back = inverse_of(node_, cell);
        const PixelSize<Real> pixel = pixel_around(node_, search_, cell.object, center.z);
        std::uint32_t inside = 0;
        for (std::uint32_t rest = asked; rest != 0; rest &= rest - 1) {
            node_.tally(Operation::loop_turn, 1);
            node_.tally(Operation::multiply_add, 4);
            node_.tally(Operation::integer, 4);
            const auto i = static_cast<std::uint32_t>(std::countr_zero(rest));
            const Vec3<Real> at = place(i);
            const PassingRay<Real> ray{
                {at.x * pixel.at_origin - center.x, at.y * pixel.at_origin - center.y, Real(0)},
                {at.x * pixel.growth, at.y * pixel.growth, Real(1)}};
            const bool met = back.flat || is_lifted(cell) ? is_near(cell, ray.aside)
                                                          : passes(node_, cell, back, ray);
            if (met) inside |= std::uint32_t{1} << i;
        }
        return inside;
    }

    [[nodiscard]] bool is_lifted(const Cell<Real>& cell) noexcept {
        node_.tally(Operation::integer, 1);
        const std::uint32_t squash =
            node_.shape_word(cell.object + ObjectRecord<real_words<Real>>::squash);
        return (squash & squash_flat) != 0;
    }
    /// Cells without thickness are seen as balls, so that they do not vanish edge on.
    [[nodiscard]] bool is_near(const Cell<Real>& cell, const Vec3<Real>& aside) noexcept {
        const Real diameter = cell_diameter(node_, cell);
        node_.tally(Operation::multiply_add, 2);
        node_.tally(Operation::compare_branch, 1);
        return !(diameter * diameter < Real(4) * dot(node_, aside, aside));
    }

    /// What the attractor covers of the cell's volume, on average; all of it where the object ends.
    [[nodiscard]] Real coverage(const Cell<Real>& cell) noexcept {
        using FollowSet = FollowSetRecord<real_words<Real>>;
        if (at_last_level(node_, cell)) return Real(1);
        node_.tally(Operation::integer, 1);
        return node_.shape_real(cell.follow_set + FollowSet::maps +
                                node_.shape_word(cell.follow_set + FollowSet::map_count));
    }

    /// Gives the cell its part of what is left of the places (Eqs. 18.5, 18.6).
    void show(const Cell<Real>& cell, std::uint32_t where, Real opacity,
              SightList<Real>& seen) noexcept {
        if (where == 0) return;
        Real sum = Real(0);
        Vec3<Real> middle{};
        for (std::uint32_t rest = where; rest != 0; rest &= rest - 1) {
            node_.tally(Operation::loop_turn, 1);
            node_.tally(Operation::multiply_add, 3);
            node_.tally(Operation::compare_branch, 1);
            node_.tally(Operation::integer, 3);
            const auto i = static_cast<std::uint32_t>(std::countr_zero(rest));
            Real part = left_[i] * opacity;
            if (left_[i] - part < least_part) part = left_[i];
            left_[i] = left_[i] - part;
            if (!(Real(0) < left_[i])) open_ &= ~(std::uint32_t{1} << i);
            sum = sum + part;
            middle = add_scaled(node_, middle, part, place(i));
        }
        node_.tally(Operation::reciprocal, 1);
        node_.tally(Operation::multiply_add, 1);
        watch(node_, CellEvent::terminal, cell);
        seen.add(node_, cell, sum * share_, scale(node_, reciprocal(sum), middle));
    }

    static constexpr Real least_part = from_double<Real>(1.0 / 64);  // of a place
    // What one search for all places may cost, as a share of the cap on cells of a ray.
    static constexpr std::uint32_t searches_a_cap = 128;

    Node& node_;
    const Search<Real>& search_;
    Linear<Real> frame_;
    std::uint32_t first_;   // address of the place of the eye's ray
    std::uint32_t record_;  // of a BeamRecord
    std::uint32_t count_;
    std::uint32_t table_;  // address of the places
    Real per_pixel_;       // count_ as a number
    Real share_;           // 1 / count_
    std::uint32_t open_;   // places that something behind may show at
    bool is_complete_ = true;
    Real left_[most_places];
};

}  // namespace pxm::kernels
