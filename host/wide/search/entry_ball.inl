// An entry cell of homotheties that is a ball, and the rays of the packet: rays in lanes first,
// then each alone, with the cells in lanes that its place in the view
// (host/wide/tables/candidate_views.hpp) lists.
#if defined(PXM_HOST_WIDE_SEARCH_ENTRY_BALL_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PXM_HOST_WIDE_SEARCH_ENTRY_BALL_INL
#undef PXM_HOST_WIDE_SEARCH_ENTRY_BALL_INL
#else
#define PXM_HOST_WIDE_SEARCH_ENTRY_BALL_INL
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/wide/search/homothety_entry.inl"
#include "host/wide/search/homothety_levels.inl"
#include "host/wide/search/homothety_single_ray.inl"

HWY_BEFORE_NAMESPACE();
namespace pxm::host::wide::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The rays of the packet beside the centre of an entry cell that is a ball, in units of its
/// radius. Depths in the packet's frame are (z + behind) / pace, with z in the view's.
struct BallRays {
    alignas(64) float x[packet_rays];  // at the centre's depth in the view's frame
    alignas(64) float y[packet_rays];
    alignas(64) float behind[packet_rays];
    alignas(64) float key[packet_rays];  // in the packet's frame
};

/// The rays of the packet in the frame of their view.
inline void spread_in_candidate_view(const WideScene& scene, SearchWorkspace& work) {
    const hn::ScalableTag<float> d;
    using V = hn::VFromD<decltype(d)>;
    CandidateViewRays& rays = work.candidate_view_rays;
    if (rays.made_for == work.packet_number) return;
    rays.made_for = work.packet_number;
    rays.candidate_view = &candidate_view_of(scene, work.packet, work.candidate_views);
    const RayPacket& packet = work.packet;
    for (int i = 0; i < 3; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            rays.turn[i][axis] =
                static_cast<float>(glm::dot(packet.axis[i], rays.candidate_view->view.axis[axis]));
        }
    }
    for (int i = 0; i < packet_rays; i += static_cast<int>(hn::Lanes(d))) {
        const V u = hn::LoadU(d, packet.u1 + i), v = hn::LoadU(d, packet.v1 + i);
        const auto along = [&](int axis) HWY_ATTR {
            return hn::Add(hn::Add(hn::Mul(u, hn::Set(d, rays.turn[0][axis])),
                                   hn::Mul(v, hn::Set(d, rays.turn[1][axis]))),
                           hn::Set(d, rays.turn[2][axis]));
        };
        const V pace = along(2);
        const V a = hn::Div(along(0), pace), b = hn::Div(along(1), pace);
        const V stretch2 = hn::Add(hn::Add(hn::Mul(a, a), hn::Mul(b, b)), hn::Set(d, 1.0F));
        hn::StoreU(pace, d, rays.pace + i);
        hn::StoreU(a, d, rays.a + i);
        hn::StoreU(b, d, rays.b + i);
        hn::StoreU(hn::Div(hn::Set(d, 1.0F), stretch2), d, rays.shrink2 + i);
    }
}

/// The list that decides for all rays of a packet what they find in an entry cell: its cells are
/// terminal, and none before them is, wherever in the cell. Null if there is none.
inline const HomothetyTable* deciding_table(const WideScene& scene, const SearchWorkspace& work,
                                            const EntryBelow& start) {
    const HomothetyCell& cell = start.cell;
    const WideSet& set = scene.sets[static_cast<std::size_t>(cell.set)];
    if (set.composed.empty() || !work.candidate_view_rays.candidate_view->view.shared)
        return nullptr;
    const double far = cell.center[2] + 1.5 * cell.size, near = cell.center[2] - 1.5 * cell.size;
    const double most = most_pixel_at(scene, work.packet, start.object, far);
    const double least = pixel_at(scene, work.packet, cell.object, std::max(near, 0.0));
    for (const HomothetyTable& table : set.composed) {
        if (cell.constant * table.most_diameter > least) continue;
        const bool leaves_none_out = most < cell.constant * table.least_skipped;
        const bool fits = start.object.levels - cell.level >= static_cast<unsigned>(table.steps);
        return leaves_none_out && fits ? &table : nullptr;
    }
    return nullptr;
}

/// The nearest of cells that are all terminal, if a ray meets one between its start and its best.
/// Returns the lane, or -1; `ray.found` is its depth.
HWY_INLINE std::int32_t nearest_cell(BallRay& ray, float x, float y, const ListedCells& cells,
                                     Found& found) {
    const hn::CappedTag<float, table_step> d;
    const hn::RebindToSigned<decltype(d)> di;
    using V = hn::VFromD<decltype(d)>;
    constexpr int at_once = table_step;  // on every register
    constexpr std::int32_t nothing = std::numeric_limits<std::int32_t>::max();
    const Slant<V> slant{hn::Set(d, ray.a), hn::Set(d, ray.b), hn::Set(d, ray.shrink2)};
    const V start = hn::Set(d, ray.start);
    V nearest = hn::Set(d, ray.best);
    auto places = hn::Set(di, nothing);
    for (int first = 0; first < cells.count; first += at_once) {
        if (first > 0 &&
            hn::GetLane(hn::MinOfLanes(d, nearest)) <= cells.z[first] - cells.radius[first]) {
            break;
        }
        const int end = std::min(cells.count, first + at_once);
        found.tested += static_cast<std::uint32_t>(end - first);
        for (int i = first; i < end; i += static_cast<int>(hn::Lanes(d))) {
            const V z = hn::LoadU(d, cells.z + i), r = hn::LoadU(d, cells.radius + i);
            const V aside_x = hn::Sub(hn::LoadU(d, cells.x + i), hn::Mul(slant.a, z));
            const V aside_y = hn::Sub(hn::LoadU(d, cells.y + i), hn::Mul(slant.b, z));
            const V u = hn::Add(hn::Set(d, x), aside_x), v = hn::Add(hn::Set(d, y), aside_y);
            const BallPass<V> pass(u, v, r, slant);
            const V half = pass.half(slant);
            const V middle = hn::Add(z, pass.ahead);
            const V key = hn::Max(hn::Sub(middle, half), start);
            auto met = hn::Le(start, hn::Add(middle, half));  // not NaN
            met = hn::And(met, hn::Lt(key, nearest));
            met = hn::And(met, hn::FirstN(d, static_cast<std::size_t>(end - i)));
            nearest = hn::IfThenElse(met, key, nearest);
            places = hn::IfThenElse(hn::RebindMask(di, met), hn::Iota(di, i), places);
        }
    }
    const float key = hn::GetLane(hn::MinOfLanes(d, nearest));
    if (!(key < ray.best)) return -1;
    const auto first = hn::RebindMask(di, hn::Eq(nearest, hn::Set(d, key)));
    const auto place =
        hn::GetLane(hn::MinOfLanes(di, hn::IfThenElse(first, places, hn::Set(di, nothing))));
    ray.found = key;
    return cells.lane[place];
}

/// An entry cell that is a ball, and the rays that look for something inside.
class BallVisit {
  public:
    BallVisit(const WideScene& scene, SearchWorkspace& work, const HomothetyCell& cell, int index)
        : scene_(scene),
          work_(work),
          seen_(work.candidate_view_rays),
          start_(scene, index, cell, cell.center[2], cell.size),
          diameter_(static_cast<float>(cell.diameter)) {}

    void visit() {
        const std::uint64_t met = meet();
        if (met == 0) return;
        const HomothetyTable* table = deciding_table(scene_, work_, start_);
        if (table != nullptr) {
            const CandidateLists& lists =
                seen_.candidate_view->table(scene_, start_.cell.object, start_.cell.set, *table);
            follow_rays(work_, start_, met, rays_.key,
                        [&](RayBelow& ray) HWY_ATTR { return look_up(ray, *table, lists); });
        } else {
            fill_first(start_, work_.opened[0]);
            follow_rays(work_, start_, met, rays_.key,
                        [&](RayBelow& ray) HWY_ATTR { return follow(ray); });
        }
    }

  private:
    /// The rays of the packet that meet the ball, a bit each.
    [[nodiscard]] std::uint64_t meet() {
        const RayPacket& packet = work_.packet;
        const HomothetyCell& cell = start_.cell;
        const hn::ScalableTag<float> d;
        using V = hn::VFromD<decltype(d)>;
        const auto over = [&](double x) { return hn::Set(d, static_cast<float>(x / cell.size)); };
        const V center_x = over(cell.center[0]), center_y = over(cell.center[1]);
        const V far = over(cell.center[2]), near = over(1);
        std::uint64_t met = 0;
        for (int i = 0; i < packet_rays; i += static_cast<int>(hn::Lanes(d))) {
            const V a = hn::LoadU(d, packet.u1 + i), b = hn::LoadU(d, packet.v1 + i);
            const V u = hn::Add(hn::Mul(hn::LoadU(d, packet.u0 + i), near), hn::Mul(a, far));
            const V v = hn::Add(hn::Mul(hn::LoadU(d, packet.v0 + i), near), hn::Mul(b, far));
            const V x = hn::Sub(center_x, u);
            const V y = hn::Sub(center_y, v);
            const Slant<V> slant{a, b, hn::LoadU(d, packet.shrink2 + i)};
            const BallPass<V> pass(x, y, hn::Set(d, 1.0F), slant);
            const V half = pass.half(slant);
            const V start = hn::Sub(hn::Mul(hn::LoadU(d, packet.start + i), near), far);
            const V key = hn::Max(hn::Sub(pass.ahead, half), start);
            const auto turned = [&](int axis) HWY_ATTR {
                return hn::Add(hn::Mul(x, hn::Set(d, seen_.turn[0][axis])),
                               hn::Mul(y, hn::Set(d, seen_.turn[1][axis])));
            };
            const V behind = turned(2);
            hn::StoreU(hn::Sub(turned(0), hn::Mul(hn::LoadU(d, seen_.a + i), behind)), d,
                       rays_.x + i);
            hn::StoreU(hn::Sub(turned(1), hn::Mul(hn::LoadU(d, seen_.b + i), behind)), d,
                       rays_.y + i);
            hn::StoreU(behind, d, rays_.behind + i);
            hn::StoreU(key, d, rays_.key + i);
            const auto here = hn::Le(start, hn::Add(pass.ahead, half));  // not NaN
            met |= lane_bits(d, here) << i;
        }
        return met & packet.inside;
    }
    [[nodiscard]] HWY_INLINE BallRay in_candidate_view(HomothetyRay ray, int i) const {
        const float pace = seen_.pace[i], behind = rays_.behind[i];
        ray.best = ray.best * pace - behind;
        ray.start = ray.start * pace - behind;
        ray.pixel_growth /= pace;
        ray.pixel_base += ray.pixel_growth * behind;
        return {ray,     seen_.a[i],           seen_.b[i],        seen_.shrink2[i],
                &scene_, seen_.candidate_view, start_.cell.object};
    }
    [[nodiscard]] HWY_INLINE float from_candidate_view(float depth, int i) const {
        return (depth + rays_.behind[i]) / seen_.pace[i];
    }
    /// A ray that finds what it looks for in one list.
    HWY_INLINE bool look_up(RayBelow& below, const HomothetyTable& table,
                            const CandidateLists& lists) const {
        const int i = below.ray;
        BallRay ray = in_candidate_view(ray_below(scene_, work_, start_, below), i);
        const float x = rays_.x[i], y = rays_.y[i];
        const std::int32_t lane = nearest_cell(ray, x, y, lists.at(table, -x, -y), below.found);
        if (lane < 0) return false;
        below.found.below_count = table.steps;
        const auto& lanes = table.lanes[static_cast<std::size_t>(lane)];
        std::copy_n(lanes.begin(), lanes.size(), below.found.below.begin());
        below.depth = from_candidate_view(ray.found, i);
        return true;
    }
    /// A ray that goes down level by level.
    HWY_INLINE bool follow(RayBelow& below) {
        const int i = below.ray;
        const HomothetyRay in_packet = ray_below(scene_, work_, start_, below);
        if (start_.last || diameter_ <= in_packet.pixel(below.depth)) {
            below.found.below_count = 0;
            return true;
        }
        BallRay ray = in_candidate_view(in_packet, i);
        if (!follow_homotheties(scene_, work_, ray, {rays_.x[i], rays_.y[i], 0, 1}, below.found))
            return false;
        below.depth = from_candidate_view(ray.found, i);
        return true;
    }

    const WideScene& scene_;
    SearchWorkspace& work_;
    const CandidateViewRays& seen_;
    const EntryBelow start_;
    float diameter_;
    BallRays rays_;
};

}  // namespace pxm::host::wide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
