// An entry cell of homotheties that is a box, and the rays of the packet: rays in lanes first, then
// each alone.
#if defined(PXM_HOST_WIDE_SEARCH_ENTRY_BOX_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PXM_HOST_WIDE_SEARCH_ENTRY_BOX_INL
#undef PXM_HOST_WIDE_SEARCH_ENTRY_BOX_INL
#else
#define PXM_HOST_WIDE_SEARCH_ENTRY_BOX_INL
#endif

#include <hwy/highway.h>

#include "host/wide/search/grid_entry.inl"
#include "host/wide/search/grid_walk.inl"
#include "host/wide/search/homothety_entry.inl"
#include "host/wide/search/homothety_levels.inl"
#include "host/wide/search/homothety_single_ray.inl"

HWY_BEFORE_NAMESPACE();
namespace pxm::host::wide::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Where a ray passes the planes through a box's centre, and its pace across each.
HWY_INLINE PlaceBelow place_in_box(const EntryRays& rays, int ray, BoxRay& box) {
    float at[3];
    for (int k = 0; k < 3; ++k) {
        const float s = rays.direction[k][ray];
        box.pace[k] = 1 / (s == 0 ? 1e-30F : s);
        at[k] = -rays.origin[k][ray] * box.pace[k];
    }
    box.know_faces();
    return {at[0], at[1], at[2], 1};
}

/// Rays that may find something in a cell: what they have found so far lies not before all of it.
inline std::uint64_t may_find(const SearchWorkspace& work, const HomothetyCell& cell) {
    constexpr double rounding = 1e-4;  // of the way through the cell; that of floats is less
    const hn::CappedTag<double, tile_side> d;
    const auto near = hn::Set(d, cell.near - rounding * (cell.far - cell.near));
    std::uint64_t rays = 0;
    for (int i = 0; i < packet_rays; i += static_cast<int>(hn::Lanes(d))) {
        rays |= lane_bits(d, hn::Lt(near, hn::LoadU(d, work.best.data() + i))) << i;
    }
    return rays & work.packet.inside;
}

inline void visit_box(const WideScene& scene, SearchWorkspace& work, const HomothetyCell& cell,
                      int index) {
    SharedCell box;
    box.spheres = false;
    EntryRays& rays = work.start;
    const WideObject& object = scene.objects[static_cast<std::size_t>(cell.object)];
    rows_of(object, work.packet, cell, box.rows, box.base);
    const EntryBelow start(scene, index, cell, box.base, 1);
    const PacketPace pace(work.packet, box, static_cast<double>(entry_rounding));
    std::uint64_t wanted = work.packet.inside;
    if (object.grid && !pace.parallel) wanted = may_find(work, cell);  // none lies in a face
    if (wanted == 0) return;
    if (object.common_grid >= 0 && !pace.parallel) {
        return GridVisit(scene, work, start, box).visit(wanted, pace.touching);
    }
    const std::uint64_t met = meet_entry_cell(work, box, rays) & wanted;
    fill_first(start, work.opened[0]);
    const auto diameter = static_cast<float>(cell.diameter);
    const auto follow = [&](RayBelow& below) HWY_ATTR {
        BoxRay ray{ray_below(scene, work, start, below), {}};
        if (start.last || diameter <= ray.pixel(below.depth)) {
            below.found.below_count = 0;
            return true;
        }
        const PlaceBelow at = place_in_box(rays, below.ray, ray);
        if (object.grid) {
            const float center[3] = {at.x, at.y, at.z};
            GridWalk walk(scene, ray);
            const std::uint32_t left = object.levels - cell.level;
            return ray.parallel ? walk.follow<true>(cell, center, left, below)
                                : walk.follow<false>(cell, center, left, below);
        }
        if (!follow_homotheties(scene, work, ray, at, below.found)) return false;
        below.depth = ray.found;
        return true;
    };
    follow_rays(work, start, met, rays.key, follow);
}

}  // namespace pxm::host::wide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
