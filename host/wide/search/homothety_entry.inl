// An entry cell of homotheties, and what the rays below it begin with.
#if defined(PXM_HOST_WIDE_SEARCH_HOMOTHETY_ENTRY_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PXM_HOST_WIDE_SEARCH_HOMOTHETY_ENTRY_INL
#undef PXM_HOST_WIDE_SEARCH_HOMOTHETY_ENTRY_INL
#else
#define PXM_HOST_WIDE_SEARCH_HOMOTHETY_ENTRY_INL
#endif

#include <hwy/highway.h>

#include <bit>

#include "host/wide/search/entry_cell.inl"
#include "host/wide/search/homothety_cells.inl"

HWY_BEFORE_NAMESPACE();
namespace pxm::host::wide::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// An entry cell, and what all rays below it have in common.
struct EntryBelow {
    int index;  // of the cell
    const HomothetyCell& cell;
    const WideObject& object;
    double base;  // depths in the cell are (z - base) / length
    double length;
    float least;  // no p is smaller
    bool last;    // the cell itself is terminal whatever its size

    EntryBelow(const WideScene& scene, int at, const HomothetyCell& from, double depth, double unit)
        : index(at),
          cell(from),
          object(scene.objects[static_cast<std::size_t>(from.object)]),
          base(depth),
          length(unit),
          least(static_cast<float>(scene.detail * object.smallest_pixel)),
          last(from.level == object.levels) {}
};

inline void fill_first(const EntryBelow& start, OpenedCell& cell) {
    cell.set = start.cell.set;
    cell.constant = static_cast<float>(start.cell.constant);
    cell.levels_left = start.object.levels - start.cell.level;
}

/// A ray of the packet that has met an entry cell.
struct RayBelow {
    int ray;
    float best;   // no cell beyond is of interest
    float depth;  // where it meets the cell, then where it meets what it found inside
    Found& found;
};

/// What such a ray needs; depths in the packet's frame, from the entry cell's base.
HWY_INLINE HomothetyRay ray_below(const WideScene& scene, const SearchWorkspace& work,
                                  const EntryBelow& start, const RayBelow& below) {
    const RayPacket& packet = work.packet;
    const int ray = below.ray;
    const auto pixel1 = static_cast<double>(packet.pixel1[ray]);
    const double pixel0 = static_cast<double>(packet.pixel0[ray]) + pixel1 * start.base;
    HomothetyRay result;
    result.best = below.best;
    result.start =
        static_cast<float>((static_cast<double>(packet.start[ray]) - start.base) / start.length);
    result.pixel_base = static_cast<float>(scene.detail * pixel0);
    result.pixel_growth = static_cast<float>(scene.detail * pixel1 * start.length);
    result.pixel_least = start.least;
    return result;
}

/// Calls `follow(RayBelow)` for the rays that have met an entry cell and found nothing nearer:
/// whether there is something below it, and at which depth.
template <class Follow>
HWY_INLINE void follow_rays(SearchWorkspace& work, const EntryBelow& start, std::uint64_t met,
                            const float* keys, const Follow& follow) {
    const double per_length = 1 / start.length;
    for (; met != 0; met &= met - 1) {
        const int i = std::countr_zero(met);
        const auto at = static_cast<std::size_t>(i);
        Found& found = work.found[at];
        ++found.tested;
        const auto best = static_cast<float>((work.best[at] - start.base) * per_length);
        if (!(keys[i] < best)) continue;
        RayBelow below{i, best, keys[i], found};
        const bool improved = follow(below);
        if (found.given_up) leave_ray(work, i);
        if (found.given_up || !improved) continue;
        const double depth = start.base + static_cast<double>(below.depth) * start.length;
        note_found(work, i, start.index, depth);
    }
}

}  // namespace pxm::host::wide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
