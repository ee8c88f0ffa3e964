// The walk of grid_walk.inl with a ray in each lane, where one grid serves all cells
// (host/wide/tables/common_grid.hpp). A place is a bit, so that what a ray has come to is asked of
// all lanes at once: whether a child is there, in which slices it is, whether the cell ends there.
// Lanes whose rays go into a child go down together, while those that are done, or are in a cell
// farther up, wait. Each lane computes what grid_walk.inl computes, in the same order.
#if defined(PXM_HOST_WIDE_SEARCH_GRID_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PXM_HOST_WIDE_SEARCH_GRID_LANES_INL
#undef PXM_HOST_WIDE_SEARCH_GRID_LANES_INL
#else
#define PXM_HOST_WIDE_SEARCH_GRID_LANES_INL
#endif

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

#include "host/wide/search/grid_rays.hpp"
#include "host/wide/search/homothety_entry.inl"

HWY_BEFORE_NAMESPACE();
namespace pxm::host::wide::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Up to a register of rays below an entry cell. `most`: slices along an axis at most.
template <int most>
class GridLanes {
    static constexpr hn::CappedTag<float, GridRays::most_lanes> d{};
    static constexpr hn::RebindToSigned<hn::CappedTag<float, GridRays::most_lanes>> di{};
    using V = hn::VFromD<decltype(d)>;
    using I = hn::VFromD<decltype(di)>;
    using M = hn::Mask<hn::CappedTag<float, GridRays::most_lanes>>;

  public:
    /// The lanes hold the rays from `first` on, of which each may test `left` boxes.
    GridLanes(const GridEntry& entry, const GridRays& rays, int first, const std::int32_t* left)
        : entry_(entry),
          start_(hn::LoadU(d, rays.start + first)),
          best_(hn::LoadU(d, rays.best + first)),
          pixel_base_(hn::LoadU(d, rays.pixel_base + first)),
          pixel_growth_(hn::LoadU(d, rays.pixel_growth + first)),
          depth_(hn::LoadU(d, rays.key + first)),
          left_(hn::LoadU(di, left)),
          count_(hn::Zero(di)),
          octant_(hn::Zero(di)),
          done_(hn::FirstN(d, 0)),
          found_(done_),
          given_up_(done_) {
        constexpr float rounding = 0x1p-20F;  // of the entry cell's half width, as BoxRay has it
        for (int k = 0; k < 3; ++k) {
            center_[k] = hn::LoadU(d, rays.center[k] + first);
            reach_[k] = hn::LoadU(d, rays.pace[k] + first);
            know_slices(k);
        }
        const V passing =
            hn::Min(hn::Min(hn::Abs(reach_[0]), hn::Abs(reach_[1])), hn::Abs(reach_[2]));
        touching_ = hn::Mul(hn::Set(d, 4 * rounding), passing);
    }

    /// Follows `count` rays to the nearest terminal cells nearer than their best.
    void follow(int count) {
        const I set = hn::Set(di, entry_.set);
        go_through({center_, reach_, depth_, occupied(set), set, entry_.constant}, 0,
                   hn::FirstN(d, static_cast<std::size_t>(count)));
    }

    /// Lanes that have found a cell, and those that are to be left to the reference kernels.
    [[nodiscard]] std::uint64_t found() const { return lane_bits(d, found_); }
    [[nodiscard]] std::uint64_t given_up() const { return lane_bits(d, given_up_); }
    /// What the lanes have found: where, and so many levels down.
    void store(float* depth, std::int32_t* levels, std::int32_t* left) const {
        hn::StoreU(depth_, d, depth);
        hn::StoreU(count_, di, levels);
        hn::StoreU(left_, di, left);
    }
    /// The lanes in a set's table that were taken on the way to what a lane has found.
    void put_word(int lane, int levels, std::uint16_t* word) const {
        alignas(64) std::int32_t octants[GridRays::most_lanes];
        hn::StoreU(octant_, di, octants);
        int set = entry_.set;
        for (int level = 0; level < levels; ++level) {
            const auto place = static_cast<std::uint32_t>(places_[level][lane]);
            const std::size_t at = CommonGrid::entry(set, octants[lane], std::countr_zero(place));
            word[level] = static_cast<std::uint16_t>(entry_.grid.lanes[at]);
            set = entry_.grid.next[at];
        }
    }

  private:
    /// A cell in each lane, as a ray has come to it.
    struct Cells {
        const V* center;  // 3
        const V* reach;   // 3
        V key;
        I occupied;  // places that hold a child
        I set;
        float constant;  // Lipschitz constant of the composed maps
    };
    /// The child that a ray has come to.
    struct Children {
        const V* center;
        V key;
        I place;
    };
    /// Where a ray is among the children of a cell.
    struct Walk {
        V planes[3][most];  // depth at which it passes the far plane of each slice
        V exit[3];          // depth at which it leaves the slice that it is in
        I place;            // a bit
    };

    /// The planes behind the slices along an axis, and their middles, as the rays come to them.
    void know_slices(int k) {
        const CommonGrid& grid = entry_.grid;
        const auto axis = static_cast<std::size_t>(k);
        const int n = grid.slices[axis];
        const auto upward = hn::Lt(hn::Zero(d), reach_[k]);
        const auto either = [&](float up, float down) HWY_ATTR {
            return hn::IfThenElse(upward, hn::Set(d, up), hn::Set(d, down));
        };
        for (int i = 0; i < most; ++i) {
            constexpr float never = std::numeric_limits<float>::infinity();
            const bool is_slice = i < n;
            const auto at = static_cast<std::size_t>(i);
            const auto back = static_cast<std::size_t>(is_slice ? n - 1 - i : 0);
            planes_[k][i] = is_slice ? either(grid.planes[axis][at + 1], grid.planes[axis][back])
                                     : either(never, -never);
            middles_[k][i] =
                is_slice ? either(grid.centers[axis][at], grid.centers[axis][back]) : hn::Zero(d);
        }
        octant_ = hn::Or(
            octant_, hn::IfThenElseZero(hn::Not(hn::RebindMask(di, upward)), hn::Set(di, 1 << k)));
        const auto& from = grid.from_slice[axis];
        for (int i = 0; i < most; ++i) from_slice_[k][i] = from[static_cast<std::size_t>(i)];
        step_[k] = grid.steps[axis];
        last_slice_[k] = from_slice_[k][n - 1];
    }
    [[nodiscard]] HWY_INLINE static M is_in(I place, I places) {
        return hn::RebindMask(d, hn::TestBit(places, place));
    }
    /// Those of the numbers of an axis that belong to the slice that a place is in.
    [[nodiscard]] HWY_INLINE V of_slice(int k, I place, const V* numbers) const {
        V number = numbers[0];
        for (int i = 1; i < most; ++i) {
            number =
                hn::IfThenElse(is_in(place, hn::Set(di, from_slice_[k][i])), numbers[i], number);
        }
        return number;
    }
    [[nodiscard]] I occupied(I set) const {
        const I row = hn::Add(hn::ShiftLeft<3>(set), octant_);
        return hn::GatherIndex(
            di, reinterpret_cast<const std::int32_t*>(entry_.grid.occupied.data()), row);
    }
    /// The place where the rays come into their cells.
    HWY_INLINE void enter(const Cells& cells, Walk& walk) const {
        walk.place = hn::Set(di, 1);
        for (int k = 0; k < 3; ++k) {
            for (int i = 0; i < most; ++i) {
                walk.planes[k][i] =
                    hn::Add(cells.center[k], hn::Mul(cells.reach[k], planes_[k][i]));
            }
            walk.exit[k] = walk.planes[k][0];
            for (int i = 1; i < most; ++i) {
                if (entry_.grid.slices[static_cast<std::size_t>(k)] <= i) break;
                const M behind = hn::Le(walk.planes[k][i - 1], cells.key);
                walk.exit[k] = hn::IfThenElse(behind, walk.planes[k][i], walk.exit[k]);
                walk.place = hn::IfThenElse(hn::RebindMask(di, behind),
                                            hn::ShiftLeftSame(walk.place, step_[k]), walk.place);
            }
        }
    }
    /// Takes the rays of some lanes into the next slice; returns those that have left their cells.
    HWY_INLINE M advance(M lanes, Walk& walk) const {
        const V x = walk.exit[0], y = walk.exit[1], z = walk.exit[2];
        const M over_y = hn::Lt(y, x);
        const M over_z = hn::Lt(z, hn::IfThenElse(over_y, y, x));
        const auto by_axis = [&](const int* numbers) HWY_ATTR {
            const I xy = hn::IfThenElse(hn::RebindMask(di, over_y), hn::Set(di, numbers[1]),
                                        hn::Set(di, numbers[0]));
            return hn::IfThenElse(hn::RebindMask(di, over_z), hn::Set(di, numbers[2]), xy);
        };
        const M left = hn::And(lanes, is_in(walk.place, by_axis(last_slice_)));
        const M inside = hn::AndNot(left, lanes);
        walk.place =
            hn::IfThenElse(hn::RebindMask(di, inside), walk.place << by_axis(step_), walk.place);
        for (int k = 0; k < 3; ++k) walk.exit[k] = of_slice(k, walk.place, walk.planes[k]);
        return left;
    }
    /// Goes through the children of the lanes' cells, so many levels below the entry cell.
    HWY_NOINLINE void go_through(const Cells& cells, int level, M lanes) {
        Walk walk;
        enter(cells, walk);
        M moving = hn::AndNot(is_in(walk.place, cells.occupied), lanes);
        while (true) {
            while (!hn::AllFalse(d, moving)) {
                lanes = hn::AndNot(advance(moving, walk), lanes);
                moving = hn::AndNot(is_in(walk.place, cells.occupied), hn::And(moving, lanes));
            }
            if (hn::AllFalse(d, lanes)) return;
            look_into(cells, walk.place, level, lanes);
            lanes = hn::AndNot(done_, lanes);
            lanes = hn::AndNot(advance(lanes, walk), lanes);
            moving = hn::AndNot(is_in(walk.place, cells.occupied), lanes);
        }
    }
    /// The rays of the lanes are where their cells have children.
    HWY_INLINE void look_into(const Cells& cells, I place, int level, M lanes) {
        left_ = hn::IfThenElse(hn::RebindMask(di, lanes), hn::Sub(left_, hn::Set(di, 1)), left_);
        give_up(hn::And(lanes, hn::RebindMask(d, hn::Lt(left_, hn::Set(di, 1)))));
        lanes = hn::AndNot(given_up_, lanes);
        V center[3];
        V key = start_;
        V exit = hn::Set(d, std::numeric_limits<float>::infinity());
        const V scale = hn::Set(d, entry_.grid.scale);
        for (int k = 0; k < 3; ++k) {
            const V middle = of_slice(k, place, middles_[k]);
            center[k] = hn::Add(cells.center[k], hn::Mul(cells.reach[k], middle));
            const V half = hn::Mul(scale, hn::Abs(cells.reach[k]));
            key = hn::Max(key, hn::Sub(center[k], half));
            exit = hn::Min(exit, hn::Add(center[k], half));
        }
        const M met = hn::And(lanes, hn::Le(key, hn::Add(exit, touching_)));
        const M near = hn::And(met, hn::Lt(key, best_));
        done_ = hn::Or(done_, hn::AndNot(near, met));  // what comes later is farther
        if (hn::AllFalse(d, near)) return;
        hn::BlendedStore(place, hn::RebindMask(di, near), di, places_[level]);
        const M terminal = hn::And(near, is_terminal(cells.constant, level, key));
        depth_ = hn::IfThenElse(terminal, key, depth_);
        count_ = hn::IfThenElse(hn::RebindMask(di, terminal), hn::Set(di, level + 1), count_);
        found_ = hn::Or(found_, terminal);
        done_ = hn::Or(done_, terminal);
        const M inward = hn::AndNot(terminal, near);
        if (hn::AllFalse(d, inward)) return;
        if (level + 1 == Found::most_below) return give_up(inward);
        go_inside(cells, {center, key, place}, level, inward);
    }
    void give_up(M lanes) {
        given_up_ = hn::Or(given_up_, lanes);
        done_ = hn::Or(done_, lanes);
    }
    [[nodiscard]] HWY_INLINE M is_terminal(float constant, int level, V key) const {
        const bool last = static_cast<std::uint32_t>(level) + 1 == entry_.levels_left;
        const V p = hn::Max(hn::Add(pixel_base_, hn::Mul(pixel_growth_, key)),
                            hn::Set(d, entry_.pixel_least));
        const float least = -std::numeric_limits<float>::infinity();
        return hn::Le(hn::Set(d, last ? least : constant * entry_.grid.diameter), p);
    }
    HWY_INLINE void go_inside(const Cells& cells, const Children& children, int level, M lanes) {
        V reach[3];
        const V scale = hn::Set(d, entry_.grid.scale);
        for (int k = 0; k < 3; ++k) reach[k] = hn::Mul(scale, cells.reach[k]);
        Cells inner{children.center, reach,     children.key,
                    cells.occupied,  cells.set, cells.constant * entry_.grid.constant};
        if (entry_.grid.sets.size() > 1) {
            inner.set = next_sets(cells.set, children.place, lanes);
            inner.occupied = occupied(inner.set);
        }
        go_through(inner, level + 1, lanes);
    }
    /// The sets of the children at places.
    [[nodiscard]] I next_sets(I set, I place, M lanes) const {
        constexpr int n = GridRays::most_lanes;
        alignas(64) std::int32_t sets[n], places[n], octants[n], next[n] = {};
        hn::StoreU(set, di, sets);
        hn::StoreU(place, di, places);
        hn::StoreU(octant_, di, octants);
        for (std::uint64_t rest = lane_bits(d, lanes); rest != 0; rest &= rest - 1) {
            const int i = std::countr_zero(rest);
            const int at = std::countr_zero(static_cast<std::uint32_t>(places[i]));
            next[i] = entry_.grid.next[CommonGrid::entry(sets[i], octants[i], at)];
        }
        return hn::LoadU(di, next);
    }

    const GridEntry& entry_;
    V center_[3], reach_[3];  // of the entry cell
    V start_, best_, pixel_base_, pixel_growth_, touching_;
    V depth_;  // of the entry cell, then of what was found
    I left_;   // boxes that may be tested
    I count_;  // levels down to what was found
    I octant_;
    M done_, found_, given_up_;
    V planes_[3][most], middles_[3][most];  // in unit coordinates
    std::int32_t from_slice_[3][most];      // places in that slice and those behind it
    int last_slice_[3];                     // places in the last one
    int step_[3];                           // from a place to that in the next slice
    alignas(64) std::int32_t places_[Found::most_below][GridRays::most_lanes];
};

}  // namespace pxm::host::wide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
