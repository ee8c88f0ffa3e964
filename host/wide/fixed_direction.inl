// One ray below a start cell whose maps are all homotheties (Ch. 13): a cell is its centre beside
// the ray, its depth and its size. Where there are few maps, their grandchildren fill the lanes.
// Conditions: host/wide/homotheties.hpp.
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
#include "host/wide/fixed_rays.inl"
#include "host/wide/grid_walk.inl"
#include "host/wide/start_cell.inl"

HWY_BEFORE_NAMESPACE();
namespace pxm::host::wide::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The tables of a set as the rays below a start cell take them.
struct TablesBelow {
    int number = -1;  // of the set
    const WideSet* set = nullptr;
    const LaneTable<float>* children = nullptr;  // centres: of balls in the bundle's frame
    const LaneTable<float>* grandchildren = nullptr;
};

inline TablesBelow tables_below(const WideScene& scene, Workspace& work, int object, int number) {
    const WideSet& set = scene.sets[static_cast<std::size_t>(number)];
    if (!scene.objects[static_cast<std::size_t>(object)].spheres) {
        return {number, &set, &set.children.rows, &set.grandchildren.rows};
    }
    const auto turned = [&](bool two) {
        return &work.turned[turn_table(scene, work, object, number, two)];
    };
    return {number, &set, turned(false), set.grandchildren.count > 0 ? turned(true) : nullptr};
}

/// Writes the lanes that lead to lane `lane` of an opened cell.
inline void keep_word(const Workspace& work, int opened, int lane, Found& found) {
    int level = work.opened[static_cast<std::size_t>(opened)].level;
    bool first = true;
    for (int at = opened; at >= 0;) {
        const Opened& cell = work.opened[static_cast<std::size_t>(at)];
        const HomothetyTable& table = *cell.table;
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
    TablesBelow tables;
    while (true) {
        const auto index = static_cast<int>(opened.size()) - 1;
        Opened& cell = opened.back();
        if (cell.set != tables.number) tables = tables_below(scene, work, start.object, cell.set);
        const std::uint32_t level = start.level + static_cast<std::uint32_t>(cell.level);
        const bool two = two_levels(ray, *tables.set, cell, level, last_level);
        cell.table = two ? &tables.set->grandchildren : &tables.set->children;
        cell.turned = two ? tables.grandchildren : tables.children;
        const HomothetyTable& table = *cell.table;
        const bool last = level + static_cast<std::uint32_t>(table.steps) == last_level;
        ray.meet(cell, table, *cell.turned, last, met);
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
            keep_word(work, index, best_lane, found);
            ray.found = nearest;
            ray.best = work.bundle.any_hit ? nowhere : nearest;
            improved = true;
        }
        if (found.tested >= scene.cell_cap) found.given_up = true;
        while (!stack.empty() && !(stack.back().key < ray.best)) stack.pop_back();
        if (stack.empty() || found.given_up) return improved;
        const Waiting next = stack.back();
        stack.pop_back();
        const Opened& outer = opened[static_cast<std::size_t>(next.block)];
        const HomothetyTable& from = *outer.table;
        Opened child;
        ray.place(outer, from, *outer.turned, next.lane, child);
        child.constant = outer.constant * from.rows.row(HomothetyTable::constant)[next.lane];
        child.set = from.sets[static_cast<std::size_t>(next.lane)];
        child.parent = next.block;
        child.lane = next.lane;
        child.level = outer.level + from.steps;
        opened.push_back(child);
    }
}

/// The rays of the bundle beside the centre of a start cell that is a ball, in units of its radius.
struct BallRays {
    alignas(64) float x[bundle_rays];
    alignas(64) float y[bundle_rays];
    alignas(64) float key[bundle_rays];
};

inline std::uint64_t meet_ball(const RayBundle& bundle, const FixedCell& cell,
                               const HullShadow& shadow, const ShadowRoom& room, BallRays& rays) {
    const hn::ScalableTag<float> d;
    using V = hn::VFromD<decltype(d)>;
    const auto over = [&](double x) { return hn::Set(d, static_cast<float>(x / cell.size)); };
    const V center_x = over(cell.center[0]), center_y = over(cell.center[1]);
    const V far = over(cell.center[2]), near = over(1);
    const double most =
        std::max(room.pixel0 + room.pixel1 * (cell.center[2] + cell.size), room.least);
    const V margin = over(most + cell.size * (bundle.reach_u1 + bundle.reach_v1));
    std::uint64_t met = 0;
    for (int i = 0; i < bundle_rays; i += static_cast<int>(hn::Lanes(d))) {
        const V a = hn::LoadU(d, bundle.u1 + i), b = hn::LoadU(d, bundle.v1 + i);
        const V u = hn::Add(hn::Mul(hn::LoadU(d, bundle.u0 + i), near), hn::Mul(a, far));
        const V v = hn::Add(hn::Mul(hn::LoadU(d, bundle.v0 + i), near), hn::Mul(b, far));
        const V x = hn::Sub(center_x, u);
        const V y = hn::Sub(center_y, v);
        const V shrink = hn::LoadU(d, bundle.shrink2 + i);
        const V slope = hn::Add(hn::Mul(a, x), hn::Mul(b, y));
        const V ahead = hn::Mul(slope, shrink);
        const V half2 = hn::Add(hn::Sub(hn::Set(d, 1.0F), hn::Add(hn::Mul(x, x), hn::Mul(y, y))),
                                hn::Mul(slope, ahead));
        const V half = hn::Sqrt(hn::Mul(hn::Max(half2, hn::Zero(d)), shrink));
        const V start = hn::Sub(hn::Mul(hn::LoadU(d, bundle.start + i), near), far);
        const V key = hn::Max(hn::Sub(ahead, half), start);
        hn::StoreU(x, d, rays.x + i);
        hn::StoreU(y, d, rays.y + i);
        hn::StoreU(key, d, rays.key + i);
        auto here = hn::And(hn::Le(hn::Zero(d), half2), hn::Le(start, hn::Add(ahead, half)));
        here = in_shadow(d, shadow, x, y, hn::Set(d, 1.0F), margin, here);
        met |= lane_bits(d, here) << i;
    }
    return met & bundle.inside;
}

/// As visit_start_cell(), for an object with a fixed direction.
inline void visit_homotheties(const WideScene& scene, Workspace& work, int index) {
    work.bundle.spread();
    const FixedCell cell = work.fixed_cells[static_cast<std::size_t>(index)];
    const WideObject& object = scene.objects[static_cast<std::size_t>(cell.object)];
    const RayBundle& bundle = work.bundle;
    BallRays balls;
    StartRays& boxes = work.start;
    const HullShadow& shadow = work.shadows[static_cast<std::size_t>(cell.object)];
    double base = cell.center[2];
    double length = cell.size;
    std::uint64_t met = 0;
    if (object.spheres) {
        met = meet_ball(bundle, cell, shadow, ShadowRoom(scene, bundle, object), balls);
    } else {
        SharedCell box;
        box.spheres = false;
        rows_of(object, bundle, cell, box.rows, box.base);
        met = meet_start_cell(work, box, boxes);
        base = box.base;
        length = 1;
    }
    const float* keys = object.spheres ? balls.key : boxes.key;
    Opened first{0, 0, 0, 1, static_cast<float>(cell.constant), cell.set, -1, 0, 0};
    FixedRay fixed;
    const auto least = static_cast<float>(scene.detail * object.smallest_pixel);
    fixed.pixel_least = least;
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
        const auto pixel1 = static_cast<double>(bundle.pixel1[i]);
        fixed.start = static_cast<float>((static_cast<double>(bundle.start[i]) - base) / length);
        fixed.pixel_base = static_cast<float>(
            scene.detail * (static_cast<double>(bundle.pixel0[i]) + pixel1 * base));
        fixed.pixel_growth = static_cast<float>(scene.detail * pixel1 * length);
        const float p = fixed.pixel(keys[i]);
        float depth = keys[i];
        if (last || diameter <= p) {
            found.below_count = 0;
        } else if (object.spheres) {
            BallRay ray{fixed,
                        bundle.u1[i],
                        bundle.v1[i],
                        bundle.shrink2[i],
                        static_cast<float>(1 / length),
                        &shadow};
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
            if (object.grid) {
                GridWalk walk(scene, ray);
                if (!walk.follow(first, keys[i], object.levels - cell.level, found, depth))
                    continue;
            } else {
                if (!follow_fixed(scene, work, cell, ray, first, object.levels, found)) continue;
                depth = ray.found;
            }
        }
        note_found(work, i, index, base + static_cast<double>(depth) * length);
    }
}

}  // namespace pxm::host::wide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
