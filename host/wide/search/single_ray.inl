// One ray below an entry cell: the children of a cell in lanes (steps 2.4.1 to 2.4.4 of Alg. 12.4
// for all maps at once). The composed maps of a cell's children are the same for all rays of the
// packet: they are made when the first ray opens the cell and kept while the packet lasts. The ray
// goes on with the nearest child, and what is left waits for its turn.
#if defined(PXM_HOST_WIDE_SEARCH_SINGLE_RAY_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PXM_HOST_WIDE_SEARCH_SINGLE_RAY_INL
#undef PXM_HOST_WIDE_SEARCH_SINGLE_RAY_INL
#else
#define PXM_HOST_WIDE_SEARCH_SINGLE_RAY_INL
#endif

#include <hwy/highway.h>

#include <bit>
#include <cstring>
#include <limits>

#include "host/wide/packet/lanes.inl"
#include "host/wide/search/packet_search.hpp"

HWY_BEFORE_NAMESPACE();
namespace pxm::host::wide::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// A cell whose children are to be made: where it is seen from the entry cell, and how large.
struct Opening {
    const float* map;     // 12 numbers, `stride` apart
    const float* linear;  // 9 numbers, `stride` apart (polar)
    int stride;
    float constant;
    int set;
    std::uint32_t level;
    int parent;
    int lane;
};

/// Composes the maps of a cell's children into the rows of a block.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE void fill_block(D d, const WideSet& set, const Opening& cell, const Block& block) {
    const int stride = block.stride;
    const auto outer = [&](const float* from, int row) HWY_ATTR {
        const float* p = from + 3 * row * cell.stride;
        return Lanes3<V>{hn::Set(d, p[0]), hn::Set(d, p[cell.stride]),
                         hn::Set(d, p[2 * cell.stride])};
    };
    for (int i = 0; i < stride; i += static_cast<int>(hn::Lanes(d))) {
        const float* table = set.f32.row(0) + i;
        const Lanes3x3<V> k = load3x3(d, table, set.stride);
        for (int r = 0; r < 3; ++r) {
            store3(transform(outer(cell.map, r), k), d, block.rows + 3 * r * stride + i, stride);
        }
        store3(add(transform(outer(cell.map, 3), k),
                   load3(d, table + ChildField::offset * set.stride, set.stride)),
               d, block.rows + 9 * stride + i, stride);
        V diameter = hn::LoadU(d, table + ChildField::diameter * set.stride);
        if (set.polar) {
            const Lanes3x3<V> t = load3x3(d, table + ChildField::forward * set.stride, set.stride);
            const Lanes3x3<V> linear{
                {outer(cell.linear, 0), outer(cell.linear, 1), outer(cell.linear, 2)}};
            const Lanes3x3<V> inner{{transform(t.row[0], linear), transform(t.row[1], linear),
                                     transform(t.row[2], linear)}};
            for (int r = 0; r < 3; ++r) {
                store3(inner.row[r], d, block.rows + (Block::linear + 3 * r) * stride + i, stride);
            }
            diameter = hn::Mul(diameter, largest_singular_value(d, inner));
        } else {
            const V constant = hn::Mul(hn::LoadU(d, table + ChildField::constant * set.stride),
                                       hn::Set(d, cell.constant));
            hn::StoreU(constant, d, block.rows + Block::constant * stride + i);
            diameter = hn::Mul(diameter, constant);
        }
        hn::StoreU(diameter, d, block.rows + Block::diameter * stride + i);
    }
}

/// Calls f with the lanes that suit rows so far apart.
template <class F>
HWY_INLINE auto with_lanes_for(int stride, const F& f) {
    if (stride == 4) return f(hn::CappedTag<float, 4>());
    if (stride == 8) return f(hn::CappedTag<float, 8>());
    return f(hn::ScalableTag<float>());
}

/// Makes the block of a cell's children.
inline int make_block(const WideScene& scene, SearchWorkspace& work, const Opening& cell,
                      std::uint32_t last_level) {
    const WideSet& set = scene.sets[static_cast<std::size_t>(cell.set)];
    Block block;
    block.set = cell.set;
    block.parent = cell.parent;
    block.lane = cell.lane;
    block.level = cell.level + 1;
    block.last = block.level == last_level;
    block.stride = block_stride(set);
    const int rows = set.polar ? Block::polar_rows : Block::product_rows;
    block.rows = work.arena.floats(static_cast<std::size_t>(rows * block.stride));
    block.opened = work.arena.ints(static_cast<std::size_t>(block.stride));
    for (int i = 0; i < block.stride; ++i) block.opened[i] = -1;
    with_lanes_for(block.stride, [&](auto d) HWY_ATTR { fill_block(d, set, cell, block); });
    work.blocks.push_back(block);
    return static_cast<int>(work.blocks.size()) - 1;
}

/// The block of a waiting cell's children.
inline int open_cell(const WideScene& scene, SearchWorkspace& work, int block_index, int lane,
                     std::uint32_t last_level) {
    const Block& block = work.blocks[static_cast<std::size_t>(block_index)];
    if (block.opened[lane] >= 0) return block.opened[lane];
    const WideSet& set = scene.sets[static_cast<std::size_t>(block.set)];
    int* opened = block.opened;
    const Opening cell{block.rows + lane,
                       block.rows + Block::linear * block.stride + lane,
                       block.stride,
                       set.polar ? 0.0F : block.rows[Block::constant * block.stride + lane],
                       set.sets[static_cast<std::size_t>(lane)],
                       block.level,
                       block_index,
                       lane};
    return opened[lane] = make_block(scene, work, cell, last_level);
}

/// A ray in an entry cell's unit coordinates; depths are measured from the entry cell's base.
struct RayInEntry {
    float origin[3];
    float direction[3];
    float pixel_base;  // detail * p = max(pixel_base + pixel_growth * depth, pixel_least)
    float pixel_growth;
    float pixel_least;
    float slack;  // of depth, that rounding may cause
    float key;    // it is in the entry cell between these depths
    float exit;
    float best;   // no cell beyond is of interest
    float found;  // depth of the terminal cell found
};

/// Part of a ray, from key to exit.
struct Interval {
    float key, exit;
};

/// The children of an entry cell.
struct EntryChildren {
    int block;
    std::uint32_t last_level;  // cells of this level are terminal whatever their size
};

/// How far rounding may move a ray's origin in the coordinates of children, given what it is in the
/// entry cell's.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE Lanes3<V> rounding_room(D d, const Lanes3x3<V>& map) {
    const V rounding = hn::Set(d, 0x1p-19F);
    const auto axis = [&](V a, V b, V c) HWY_ATTR {
        return hn::Mul(rounding, hn::Add(hn::Add(hn::Abs(a), hn::Abs(b)), hn::Abs(c)));
    };
    return {axis(map.row[0].x, map.row[1].x, map.row[2].x),
            axis(map.row[0].y, map.row[1].y, map.row[2].y),
            axis(map.row[0].z, map.row[1].z, map.row[2].z)};
}

/// Tests children of a block, from `met.first` on: those that the ray meets within an interval and
/// nearer than its best. False if the ray lies in the face of a box, where floats cannot tell.
template <bool spheres, class D, class V = hn::VFromD<D>>
[[nodiscard]] HWY_INLINE bool meet_children(D d, const Block& block, const RayInEntry& ray,
                                            const Interval& within, MetChildren& met) {
    const int stride = block.stride;
    const Lanes3<V> origin = broadcast(d, ray.origin);
    const Lanes3<V> direction = broadcast(d, ray.direction);
    const V outer_key = hn::Set(d, within.key), outer_exit = hn::Set(d, within.exit);
    const V best = hn::Set(d, ray.best), slack = hn::Set(d, ray.slack);
    bool clear = true;
    met.waiting = met.terminal = 0;
    for (int i = 0; i < met.count; i += static_cast<int>(hn::Lanes(d))) {
        const float* rows = block.rows + met.first + i;
        const Lanes3x3<V> map = load3x3(d, rows, stride);
        const Lanes3<V> o = add(transform(origin, map), load3(d, rows + 9 * stride, stride));
        const Lanes3<V> v = transform(direction, map);
        const LaneInterval<V> inside = spheres ? in_unit_ball(d, o, v) : in_unit_cube(d, o, v);
        const auto filled = hn::FirstN(d, static_cast<std::size_t>(met.count - i));
        auto here = hn::Le(inside.key, inside.exit);  // not NaN
        if constexpr (!spheres) {
            const V touching = hn::Set(d, 4 * ray.slack);  // boxes that touch in an edge
            here = hn::Le(inside.key, hn::Add(inside.exit, touching));
            const auto in_face = in_cube_face(d, o, v, rounding_room(d, map));
            clear = clear && hn::AllFalse(d, hn::And(in_face, filled));
        }
        const V from = hn::Max(outer_key, inside.key);
        const V to = hn::Min(outer_exit, inside.exit);
        here = hn::And(here, hn::Le(from, hn::Add(to, slack)));
        here = hn::And(here, hn::Lt(from, best));
        here = hn::And(here, filled);
        const V p = hn::Max(
            hn::Add(hn::Set(d, ray.pixel_base), hn::Mul(hn::Set(d, ray.pixel_growth), from)),
            hn::Set(d, ray.pixel_least));
        const V diameter = hn::LoadU(d, rows + Block::diameter * stride);
        hn::StoreU(from, d, met.key + i);
        hn::StoreU(hn::Max(from, to), d, met.exit + i);
        met.waiting |= lane_bits(d, here) << i;
        met.terminal |= lane_bits(d, hn::Le(diameter, p)) << i;
    }
    if (block.last) met.terminal = ~std::uint64_t{0};
    return clear;
}

/// The nearest of the cells that wait, if it is nearer than `best`; otherwise -1.
HWY_INLINE int nearest_waiting(const MetCells& cells, float best) {
    const hn::CappedTag<float, table_step> d;
    using V = hn::VFromD<decltype(d)>;
    if (cells.waiting == 0) return -1;
    if ((cells.waiting & (cells.waiting - 1)) == 0) {
        const int only = std::countr_zero(cells.waiting);
        return cells.key[only] < best ? only : -1;
    }
    V nearest = hn::Set(d, best);
    const auto waiting_at = [&](int i) HWY_ATTR {
        const std::uint64_t bits = cells.waiting >> i;
        std::uint8_t bytes[8];
        std::memcpy(bytes, &bits, sizeof bits);
        return hn::IfThenElse(hn::LoadMaskBits(d, bytes), hn::LoadU(d, cells.key + i),
                              hn::Set(d, std::numeric_limits<float>::infinity()));
    };
    const auto lanes = static_cast<int>(hn::Lanes(d));
    for (int i = 0; i < cells.count; i += lanes) nearest = hn::Min(nearest, waiting_at(i));
    nearest = hn::MinOfLanes(d, nearest);
    if (!(hn::GetLane(nearest) < best)) return -1;
    for (int i = 0; i < cells.count; i += lanes) {
        const std::uint64_t same = lane_bits(d, hn::Eq(waiting_at(i), nearest));
        if (same != 0) return i + std::countr_zero(same);
    }
    return -1;
}

/// Follows a ray from the entry cell (already met, not terminal) to the nearest terminal cell that
/// is nearer than `ray.best`. True, and `found` changed, if there is one.
inline bool follow_ray(const WideScene& scene, SearchWorkspace& work, RayInEntry& ray,
                       const EntryChildren& entry, Found& found) {
    std::vector<MetChildren>& stack = work.met;
    std::size_t depth = 0;
    const auto open = [&](int index, const Interval& within) HWY_ATTR {
        const Block& block = work.blocks[static_cast<std::size_t>(index)];
        const WideSet& set = scene.sets[static_cast<std::size_t>(block.set)];
        found.tested += static_cast<std::uint32_t>(set.count);
        for (int first = 0; first < set.count; first += MetCells::room) {
            if (depth == stack.size()) stack.emplace_back();
            MetChildren& met = stack[depth++];
            met.block = index;
            met.first = first;
            met.count = std::min(MetCells::room, set.count - first);
            const bool clear = with_lanes_for(block.stride, [&](auto d) HWY_ATTR {
                return set.spheres ? meet_children<true>(d, block, ray, within, met)
                                   : meet_children<false>(d, block, ray, within, met);
            });
            if (!clear) found.given_up = true;
        }
    };
    open(entry.block, {ray.key, ray.exit});
    bool improved = false;
    while (depth > 0 && !found.given_up) {
        MetChildren& met = stack[depth - 1];
        const int i = nearest_waiting(met, ray.best);
        if (i < 0) {
            --depth;
            continue;
        }
        met.waiting &= ~(std::uint64_t{1} << i);
        const int lane = met.first + i;
        if ((met.terminal >> i & 1) != 0) {
            ray.best = ray.found = met.key[i];
            found.block = met.block;
            found.lane = lane;
            improved = true;
            if (work.packet.any_hit) return true;
            --depth;
            continue;
        }
        if (found.tested >= scene.cell_cap || work.arena.is_full()) {
            found.given_up = true;
            return improved;
        }
        const Interval within{met.key[i], met.exit[i]};
        open(open_cell(scene, work, met.block, lane, entry.last_level), within);
    }
    return improved;
}

}  // namespace pxm::host::wide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
