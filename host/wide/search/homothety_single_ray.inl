// One ray below an entry cell whose maps are all homotheties (Ch. 13): a cell is where the ray
// passes its centre, and its size. Each step goes down as many levels at once as leave no terminal
// cell out. Conditions: host/wide/tables/homothety_tables.hpp.
#if defined(PXM_HOST_WIDE_SEARCH_HOMOTHETY_SINGLE_RAY_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PXM_HOST_WIDE_SEARCH_HOMOTHETY_SINGLE_RAY_INL
#undef PXM_HOST_WIDE_SEARCH_HOMOTHETY_SINGLE_RAY_INL
#else
#define PXM_HOST_WIDE_SEARCH_HOMOTHETY_SINGLE_RAY_INL
#endif

#include <hwy/highway.h>

#include <algorithm>

#include "host/wide/search/homothety_cells.inl"
#include "host/wide/search/single_ray.inl"

HWY_BEFORE_NAMESPACE();
namespace pxm::host::wide::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Writes the lanes that were taken in so many opened cells, one below the other.
inline void keep_word(const SearchWorkspace& work, int count, Found& found) {
    int level = 0;
    for (int at = 0; at < count; ++at) {
        const OpenedCell& cell = work.opened[static_cast<std::size_t>(at)];
        const HomothetyTable& table = *cell.table;
        const auto& lanes = table.lanes[static_cast<std::size_t>(cell.lane[cell.taken])];
        if (level + table.steps > Found::most_below) {
            found.given_up = true;
            return;
        }
        for (int step = 0; step < table.steps; ++step) {
            found.below[static_cast<std::size_t>(level++)] = lanes[static_cast<std::size_t>(step)];
        }
    }
    found.below_count = level;
}

/// The cells inside of an opened one that a ray is tested against: as many levels down as possible
/// without leaving out a terminal cell on the way.
template <class Ray>
HWY_INLINE ListedCells choose_cells(const WideScene& scene, const Ray& ray, const PlaceBelow& at,
                                    OpenedCell& cell) {
    const WideSet& set = scene.sets[static_cast<std::size_t>(cell.set)];
    if (!set.composed.empty()) {
        const float p = ray.pixel(ray.deepest(at));
        for (auto table = set.composed.rbegin(); table != set.composed.rend(); ++table) {
            if (!(p < cell.constant * table->least_skipped)) continue;
            if (table->count > table_step && !ray.has_lists()) continue;
            if (cell.levels_left < static_cast<std::uint32_t>(table->steps)) continue;
            const ListedCells cells = ray.cells_of(at, cell.set, *table);
            if (cells.count > OpenedCell::room) continue;
            cell.table = &*table;
            return cells;
        }
    }
    cell.table = &set.children;
    return ray.cells_of(at, cell.set, set.children);
}

/// Tests what is inside of a cell; set, constant and levels are filled in.
template <class Ray>
HWY_INLINE void open_below(const WideScene& scene, const Ray& ray, const PlaceBelow& at,
                           OpenedCell& cell, Found& found) {
    const ListedCells cells = choose_cells(scene, ray, at, cell);
    cell.lane = cells.lane;
    cell.count = cells.count;
    cell.waiting = 0;
    cell.terminal = 0;
    cell.in_face = false;
    ray.test(at, cells, cell);
    if (cell.in_face) found.given_up = true;
    if (cell.levels_left == static_cast<std::uint32_t>(cell.table->steps)) {
        cell.terminal = ~std::uint64_t{0};
    }
    found.tested += static_cast<std::uint32_t>(cells.count);
}

/// As follow_ray(), for cells of homotheties: from the entry cell, which is filled into the first
/// of the opened ones, on.
template <class Ray>
inline bool follow_homotheties(const WideScene& scene, SearchWorkspace& work, Ray& ray,
                               const PlaceBelow& first, Found& found) {
    int depth = 0;
    open_below(scene, ray, first, work.opened[0], found);
    bool improved = false;
    while (true) {
        if (found.given_up) return improved;
        OpenedCell& cell = work.opened[static_cast<std::size_t>(depth)];
        const int i = nearest_waiting(cell, ray.best);
        if (i < 0) {
            if (depth-- == 0) return improved;
            continue;
        }
        cell.taken = i;
        cell.waiting &= ~(std::uint64_t{1} << i);
        if ((cell.terminal >> i & 1) != 0) {
            ray.best = ray.found = cell.key[i];
            keep_word(work, depth + 1, found);
            improved = true;
            if (depth-- == 0 || work.packet.any_hit || found.given_up) return true;
            continue;
        }
        if (found.tested >= scene.cell_cap || depth + 1 == Found::most_below) {
            found.given_up = true;
            return improved;
        }
        OpenedCell& inner = work.opened[static_cast<std::size_t>(++depth)];
        const auto lane = static_cast<std::size_t>(cell.lane[i]);
        inner.set = cell.table->sets[lane];
        inner.constant = cell.constant * cell.table->rows.row(HomothetyTable::constant)[lane];
        inner.levels_left = cell.levels_left - static_cast<std::uint32_t>(cell.table->steps);
        open_below(scene, ray, {cell.x[i], cell.y[i], cell.z[i], cell.size[i]}, inner, found);
    }
}

}  // namespace pxm::host::wide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
