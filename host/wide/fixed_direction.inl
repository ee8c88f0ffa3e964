// One ray below a start cell whose maps are all homotheties (Ch. 13): the ray's direction is the
// same in all cells, so a cell is its centre beside the ray, its depth and its size, and a child is
// met if a circle, or three intervals, say so. Where there are few maps, their grandchildren fill
// the lanes (Conditions: host/wide/homotheties.hpp).
#if defined(PXM_HOST_WIDE_FIXED_DIRECTION_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PXM_HOST_WIDE_FIXED_DIRECTION_INL
#undef PXM_HOST_WIDE_FIXED_DIRECTION_INL
#else
#define PXM_HOST_WIDE_FIXED_DIRECTION_INL
#endif

#include <hwy/highway.h>

#include <bit>
#include <cmath>

#include "host/wide/fixed_levels.inl"
#include "host/wide/start_cell.inl"

HWY_BEFORE_NAMESPACE();
namespace pxm::host::wide::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// What a ray needs to know of p and of itself, whatever the volumes. Depths are in units of
/// `length` from the start cell's base.
struct FixedRay {
    float pixel_base;
    float pixel_growth;
    float pixel_least;
    float eye;         // depth of the eye: keys are no less
    float pass_share;  // allowed_share, of p itself
    float best;        // no cell beyond is of interest
    float found = 0;   // depth of the terminal cell found

    [[nodiscard]] float pixel(float depth) const {
        return std::max(pixel_base + pixel_growth * depth, pixel_least);
    }
};

/// Children that a ray meets: depth and lane, terminal_bit as elsewhere.
struct MetLanes {
    alignas(64) float keys[most_children + register_room];
    alignas(64) std::int32_t lanes[most_children + register_room];
    int count = 0;
};

/// Keeps the lanes that are met, ahead of the eye and nearer than the best.
template <class D, class V = hn::VFromD<D>, class M>
HWY_INLINE void keep(D d, const FixedRay& ray, const HomothetyTable& table, int i, float constant,
                     bool last, V key, V exit, M met, MetLanes& found) {
    const hn::RebindToSigned<D> di;
    const V eye = hn::Set(d, ray.eye);
    key = hn::Max(key, eye);
    met = hn::And(met, hn::And(hn::Le(key, exit), hn::Lt(key, hn::Set(d, ray.best))));
    met = hn::And(met, hn::FirstN(d, static_cast<std::size_t>(table.count - i)));
    if (hn::AllFalse(d, met)) return;
    const V p =
        hn::Max(hn::Add(hn::Set(d, ray.pixel_base), hn::Mul(hn::Set(d, ray.pixel_growth), key)),
                hn::Set(d, ray.pixel_least));
    const V diameter =
        hn::Mul(hn::Set(d, constant), hn::LoadU(d, table.rows.row(HomothetyTable::diameter) + i));
    const auto terminal = last ? hn::FirstN(d, hn::Lanes(d)) : hn::Le(diameter, p);
    const auto lane = hn::Or(hn::Iota(di, i), hn::IfThenElseZero(hn::RebindMask(di, terminal),
                                                                 hn::Set(di, terminal_bit)));
    hn::StoreU(hn::Compress(key, met), d, found.keys + found.count);
    hn::StoreU(hn::Compress(lane, hn::RebindMask(di, met)), di, found.lanes + found.count);
    found.count += static_cast<int>(hn::CountTrue(d, met));
}

/// Balls: lengths in units of the start cell's radius, (x, y) beside the ray at the centre's depth.
struct BallRay : FixedRay {
    float a;  // the ray moves sideways by (a, b) per depth
    float b;
    float shrink2;  // 1 / (1 + a^2 + b^2)

    /// `turned`: the table's centres in the tile's frame.
    HWY_INLINE void meet(const Opened& cell, const HomothetyTable& table,
                         const LaneTable<float>& turned, bool last, MetLanes& met) const {
        const hn::ScalableTag<float> d;
        using V = hn::VFromD<decltype(d)>;
        const V va = hn::Set(d, a), vb = hn::Set(d, b), shrink = hn::Set(d, shrink2);
        const V size = hn::Set(d, cell.size);
        met.count = 0;
        for (int i = 0; i < table.count; i += static_cast<int>(hn::Lanes(d))) {
            const Lanes3<V> q = load3(d, turned.row(0) + i, table.stride);
            const V beside_x = hn::Sub(q.x, hn::Mul(va, q.z));
            const V beside_y = hn::Sub(q.y, hn::Mul(vb, q.z));
            const V x = hn::Add(hn::Set(d, cell.x), hn::Mul(size, beside_x));
            const V y = hn::Add(hn::Set(d, cell.y), hn::Mul(size, beside_y));
            const V z = hn::Add(hn::Set(d, cell.z), hn::Mul(size, q.z));
            const V r = hn::Mul(size, hn::LoadU(d, table.rows.row(HomothetyTable::scale) + i));
            // The foot of the perpendicular is a little off the centre's depth: rays are oblique.
            const V slope = hn::Add(hn::Mul(va, x), hn::Mul(vb, y));
            const V ahead = hn::Mul(slope, shrink);
            const V away2 = hn::Add(hn::Mul(x, x), hn::Mul(y, y));
            const V half2 = hn::Add(hn::Sub(hn::Mul(r, r), away2), hn::Mul(slope, ahead));
            const auto inside = hn::Le(hn::Zero(d), half2);
            if (hn::AllFalse(d, inside)) continue;
            const V half = hn::Sqrt(hn::Mul(half2, shrink));
            const V middle = hn::Add(z, ahead);
            keep(d, *this, table, i, cell.constant, last, hn::Sub(middle, half),
                 hn::Add(middle, half), inside, met);
        }
    }
    /// The cell in a lane.
    HWY_INLINE void place(const Opened& cell, const HomothetyTable& table,
                          const LaneTable<float>& turned, int lane, Opened& child) const {
        const float qz = turned.row(2)[lane];
        child.x = cell.x + cell.size * (turned.row(0)[lane] - a * qz);
        child.y = cell.y + cell.size * (turned.row(1)[lane] - b * qz);
        child.z = cell.z + cell.size * qz;
        child.size = cell.size * table.rows.row(HomothetyTable::scale)[lane];
    }
    /// Not less than the key of any cell inside.
    [[nodiscard]] float deepest(const Opened& cell) const { return cell.z + 1.5F * cell.size; }
};

/// Boxes: x, y, z are the depths at which the ray passes the centre's three planes.
struct BoxRay : FixedRay {
    float pace[3];  // depth per unit of each axis

    HWY_INLINE void meet(const Opened& cell, const HomothetyTable& table,
                         const LaneTable<float>& /*turned*/, bool last, MetLanes& met) const {
        const hn::ScalableTag<float> d;
        using V = hn::VFromD<decltype(d)>;
        const float c[3] = {cell.x, cell.y, cell.z};
        met.count = 0;
        for (int i = 0; i < table.count; i += static_cast<int>(hn::Lanes(d))) {
            const V size = hn::Mul(hn::Set(d, cell.size),
                                   hn::LoadU(d, table.rows.row(HomothetyTable::scale) + i));
            const auto slab = [&](int k) HWY_ATTR {
                const V q = hn::LoadU(d, table.rows.row(k) + i);
                const V middle =
                    hn::Add(hn::Set(d, c[k]), hn::Mul(hn::Set(d, cell.size * pace[k]), q));
                const V half = hn::Mul(size, hn::Set(d, std::abs(pace[k])));
                return LaneInterval<V>{hn::Sub(middle, half), hn::Add(middle, half)};
            };
            const LaneInterval<V> x = slab(0), y = slab(1), z = slab(2);
            const V key = max3(x.key, y.key, z.key);
            const V exit = hn::Min(hn::Min(x.exit, y.exit), z.exit);
            keep(d, *this, table, i, cell.constant, last, key, exit, hn::Le(key, exit), met);
        }
    }
    HWY_INLINE void place(const Opened& cell, const HomothetyTable& table,
                          const LaneTable<float>& /*turned*/, int lane, Opened& child) const {
        child.x = cell.x + cell.size * pace[0] * table.rows.row(0)[lane];
        child.y = cell.y + cell.size * pace[1] * table.rows.row(1)[lane];
        child.z = cell.z + cell.size * pace[2] * table.rows.row(2)[lane];
        child.size = cell.size * table.rows.row(HomothetyTable::scale)[lane];
    }
    [[nodiscard]] float deepest(const Opened& cell) const {
        float exit = std::numeric_limits<float>::infinity();
        const float c[3] = {cell.x, cell.y, cell.z};
        for (int k = 0; k < 3; ++k) exit = std::min(exit, c[k] + cell.size * std::abs(pace[k]));
        return exit;
    }
};

/// The centres of a set's table as the rays take them: for balls in the tile's frame.
inline const LaneTable<float>& centers_of(const WideScene& scene, Workspace& work,
                                          const FixedCell& start, int set_index, bool two) {
    if (scene.objects[static_cast<std::size_t>(start.object)].spheres) {
        return work.turned[turn_table(scene, work, start.object, set_index, two)];
    }
    const WideSet& set = scene.sets[static_cast<std::size_t>(set_index)];
    return two ? set.grandchildren.rows : set.children.rows;
}

/// Writes the lanes that lead to lane `lane` of an opened cell.
inline void keep_word(const WideScene& scene, const Workspace& work, int opened, int lane,
                      Found& found) {
    int level = work.opened[static_cast<std::size_t>(opened)].level;
    bool first = true;
    for (int at = opened; at >= 0;) {
        const Opened& cell = work.opened[static_cast<std::size_t>(at)];
        const WideSet& set = scene.sets[static_cast<std::size_t>(cell.set)];
        const HomothetyTable& table = cell.two ? set.grandchildren : set.children;
        if (first) {
            level = cell.level + table.steps;
            found.below_count = level;
            if (level > Found::most_below) {
                found.given_up = true;
                return;
            }
            first = false;
        }
        const auto& lanes = table.lanes[static_cast<std::size_t>(lane)];
        for (int step = table.steps; step > 0; --step) {
            found.below[static_cast<std::size_t>(--level)] =
                lanes[static_cast<std::size_t>(step - 1)];
        }
        lane = cell.lane;
        at = cell.parent;
    }
}

/// Whether a cell's grandchildren can be tested at once: none of its children is terminal.
template <class Ray>
HWY_INLINE bool two_levels(const Ray& ray, const WideSet& set, const Opened& cell,
                           std::uint32_t level, std::uint32_t last_level) {
    if (set.grandchildren.count == 0 || last_level < level + 2) return false;
    const float p =
        std::max(ray.pixel_base + ray.pixel_growth * ray.deepest(cell), ray.pixel_least);
    return p < cell.constant * set.grandchildren.least_skipped;
}

/// As follow_ray(), for cells of homotheties. `first` is the start cell.
template <class Ray>
inline bool follow_fixed(const WideScene& scene, Workspace& work, const FixedCell& start, Ray& ray,
                         const Opened& first, std::uint32_t last_level, Found& found) {
    MetLanes met;
    std::vector<Waiting>& stack = work.stack;
    std::vector<Opened>& opened = work.opened;
    stack.clear();
    opened.clear();
    opened.push_back(first);
    bool improved = false;
    while (true) {
        const auto index = static_cast<int>(opened.size()) - 1;
        Opened& cell = opened.back();
        const WideSet& set = scene.sets[static_cast<std::size_t>(cell.set)];
        const std::uint32_t level = start.level + static_cast<std::uint32_t>(cell.level);
        cell.two = two_levels(ray, set, cell, level, last_level);
        const HomothetyTable& table = cell.two ? set.grandchildren : set.children;
        const bool last = level + static_cast<std::uint32_t>(table.steps) == last_level;
        const LaneTable<float>& turned = centers_of(scene, work, start, cell.set, cell.two);
        ray.meet(cell, table, turned, last, met);
        found.tested += static_cast<std::uint32_t>(table.count);
        const std::size_t bottom = stack.size();
        int best_lane = -1;
        float nearest = ray.best;
        for (int i = 0; i < met.count; ++i) {
            const float key = met.keys[i];
            if (!(key < nearest)) continue;
            const std::int32_t lane = met.lanes[i] & ~terminal_bit;
            if (met.lanes[i] & terminal_bit) {
                nearest = key;
                best_lane = lane;
                continue;
            }
            stack.push_back({key, 0, index, lane});
            for (std::size_t k = stack.size() - 1; k > bottom && stack[k - 1].key < key; --k) {
                std::swap(stack[k - 1], stack[k]);
            }
        }
        if (best_lane >= 0) {
            keep_word(scene, work, index, best_lane, found);
            ray.found = nearest;
            ray.best = nearest - ray.pass_share * ray.pixel(nearest);
            improved = true;
        }
        if (found.tested >= scene.cell_cap) found.given_up = true;
        while (!stack.empty() && !(stack.back().key < ray.best)) stack.pop_back();
        if (stack.empty() || found.given_up) return improved;
        const Waiting next = stack.back();
        stack.pop_back();
        const Opened& outer = opened[static_cast<std::size_t>(next.block)];
        const WideSet& outer_set = scene.sets[static_cast<std::size_t>(outer.set)];
        const HomothetyTable& from = outer.two ? outer_set.grandchildren : outer_set.children;
        Opened child;
        const LaneTable<float>& from_turned = centers_of(scene, work, start, outer.set, outer.two);
        ray.place(outer, from, from_turned, next.lane, child);
        child.constant = outer.constant * from.rows.row(HomothetyTable::constant)[next.lane];
        child.set = from.sets[static_cast<std::size_t>(next.lane)];
        child.parent = next.block;
        child.lane = next.lane;
        child.level = outer.level + from.steps;
        child.two = false;
        opened.push_back(child);
    }
}

/// The rays of the tile beside the centre of a start cell that is a ball, in units of its radius.
struct BallRays {
    alignas(64) float x[tile_rays];
    alignas(64) float y[tile_rays];
    alignas(64) float key[tile_rays];
};

inline std::uint64_t meet_ball(const TileView& tile, const FixedCell& cell, BallRays& rays) {
    const hn::ScalableTag<float> d;
    using V = hn::VFromD<decltype(d)>;
    const auto over = [&](double x) { return hn::Set(d, static_cast<float>(x / cell.size)); };
    const V center_x = over(cell.center[0]), center_y = over(cell.center[1]);
    const V far = over(cell.center[2]), near = over(1);
    const V behind_eye = hn::Neg(far);
    std::uint64_t met = 0;
    for (int i = 0; i < tile_rays; i += static_cast<int>(hn::Lanes(d))) {
        const V a = hn::LoadU(d, tile.u1 + i), b = hn::LoadU(d, tile.v1 + i);
        const V u = hn::Add(hn::Mul(hn::LoadU(d, tile.u0 + i), near), hn::Mul(a, far));
        const V v = hn::Add(hn::Mul(hn::LoadU(d, tile.v0 + i), near), hn::Mul(b, far));
        const V x = hn::Sub(center_x, u);
        const V y = hn::Sub(center_y, v);
        const V shrink = hn::LoadU(d, tile.shrink2 + i);
        const V slope = hn::Add(hn::Mul(a, x), hn::Mul(b, y));
        const V ahead = hn::Mul(slope, shrink);
        const V half2 = hn::Add(hn::Sub(hn::Set(d, 1.0F), hn::Add(hn::Mul(x, x), hn::Mul(y, y))),
                                hn::Mul(slope, ahead));
        const V half = hn::Sqrt(hn::Mul(hn::Max(half2, hn::Zero(d)), shrink));
        const V key = hn::Max(hn::Sub(ahead, half), behind_eye);
        hn::StoreU(x, d, rays.x + i);
        hn::StoreU(y, d, rays.y + i);
        hn::StoreU(key, d, rays.key + i);
        const auto here =
            hn::And(hn::Le(hn::Zero(d), half2), hn::Le(behind_eye, hn::Add(ahead, half)));
        std::uint8_t bits[8] = {};
        hn::StoreMaskBits(d, here, bits);
        std::uint64_t word = 0;
        for (int k = 0; k < 8; ++k) word |= std::uint64_t{bits[k]} << (8 * k);
        met |= word << i;
    }
    return met & tile.inside;
}

/// As visit_start_cell(), for an object with a fixed direction.
inline void visit_homotheties(const WideScene& scene, Workspace& work, int index) {
    const FixedCell cell = work.fixed_cells[static_cast<std::size_t>(index)];
    const WideObject& object = scene.objects[static_cast<std::size_t>(cell.object)];
    const TileView& tile = work.tile;
    BallRays balls;
    StartRays& boxes = work.start;
    double base = cell.center[2];
    double length = cell.size;
    std::uint64_t met = 0;
    if (object.spheres) {
        met = meet_ball(tile, cell, balls);
    } else {
        SharedCell box;
        box.spheres = false;
        rows_of(object, tile, cell, box.rows, box.base);
        met = meet_start_cell(work, box, boxes);
        base = box.base;
        length = 1;
    }
    const float* keys = object.spheres ? balls.key : boxes.key;
    Opened first{0, 0, 0, 1, static_cast<float>(cell.constant), cell.set, -1, 0, 0, false};
    FixedRay fixed;
    const auto least = static_cast<float>(scene.detail * object.smallest_pixel);
    fixed.pixel_least = least;
    fixed.pass_share = allowed_share / static_cast<float>(scene.detail);
    fixed.eye = static_cast<float>(-base / length);
    const auto base_p = static_cast<float>(scene.detail * scene.camera.pixel_growth * base);
    const auto growth = static_cast<float>(scene.detail * scene.camera.pixel_growth * length);
    const auto at_eye = static_cast<float>(scene.detail * scene.camera.pixel_at_eye);
    const auto diameter = static_cast<float>(cell.diameter);
    const bool last = cell.level == object.levels;
    for (; met != 0; met &= met - 1) {
        const int i = std::countr_zero(met);
        const auto at = static_cast<std::size_t>(i);
        Found& found = work.found[at];
        ++found.tested;
        const float best = static_cast<float>((work.best[at] - base) / length);
        if (!(keys[i] < best)) continue;
        fixed.best = best;
        fixed.pixel_base = at_eye + base_p * tile.stretch[i];
        fixed.pixel_growth = growth * tile.stretch[i];
        const float p = fixed.pixel(keys[i]);
        float depth = keys[i];
        if (last || diameter <= p) {
            found.below_count = 0;
        } else if (object.spheres) {
            BallRay ray{fixed, tile.u1[i], tile.v1[i], tile.shrink2[i]};
            first.x = balls.x[i];
            first.y = balls.y[i];
            if (!follow_fixed(scene, work, cell, ray, first, object.levels, found)) continue;
            depth = ray.found;
        } else {
            BoxRay ray{fixed, {}};
            float* const place[3] = {&first.x, &first.y, &first.z};
            for (int k = 0; k < 3; ++k) {
                const float s = boxes.direction[k][i];
                ray.pace[k] = 1 / (s == 0 ? 1e-30F : s);
                *place[k] = -boxes.origin[k][i] * ray.pace[k];
            }
            if (!follow_fixed(scene, work, cell, ray, first, object.levels, found)) continue;
            depth = ray.found;
        }
        note_found(work, i, index, base + static_cast<double>(depth) * length,
                   static_cast<double>(p) / scene.detail);
    }
}

}  // namespace pxm::host::wide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
