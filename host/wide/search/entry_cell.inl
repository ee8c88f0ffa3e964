// An entry cell and the rays of the packet, rays in lanes, in float: which rays meet it, and where.
#if defined(PXM_HOST_WIDE_SEARCH_ENTRY_CELL_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PXM_HOST_WIDE_SEARCH_ENTRY_CELL_INL
#undef PXM_HOST_WIDE_SEARCH_ENTRY_CELL_INL
#else
#define PXM_HOST_WIDE_SEARCH_ENTRY_CELL_INL
#endif

#include <hwy/highway.h>

#include <bit>
#include <cmath>

#include "host/wide/packet/packet_lanes.inl"
#include "host/wide/search/packet_levels.inl"
#include "host/wide/search/single_ray.inl"

HWY_BEFORE_NAMESPACE();
namespace pxm::host::wide::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The rays of the packet go on alone from here.
inline void begin_looking(SearchWorkspace& work) {
    if (work.looking) return;
    work.looking = true;
    spread_rays(work.packet);
    work.clear_found();
}

/// Leaves a ray to the reference kernels, which follow it in double: too many cells are on its way,
/// or it lies in a face between two boxes, and floats cannot tell which of the two it meets.
inline void leave_ray(SearchWorkspace& work, int ray) {
    const auto at = static_cast<std::size_t>(ray);
    work.found[at].given_up = true;
    work.best[at] = 0;  // nothing to look for
    work.improved = true;
}

/// How far rounding may move a ray, in half widths of an entry cell.
inline constexpr float entry_rounding = 0x1p-18F;

/// How the rays of a packet move in a cell.
struct PacketPace {
    float touching;  // of depth, that rounding may part boxes by that touch in an edge
    bool parallel;   // a ray may hardly move along an axis, and lie in faces across it

    PacketPace(const RayPacket& packet, const SharedCell& cell, double rounding) {
        double fastest = 0, slowest = beyond;
        for (std::size_t k = 0; k < 3; ++k) {
            const double along = std::abs(cell.rows[6 + k]);
            const double spread = std::abs(cell.rows[k]) * packet.reach_u1 +
                                  std::abs(cell.rows[3 + k]) * packet.reach_v1;
            fastest = std::max(fastest, along + spread);
            slowest = std::min(slowest, along - spread);
        }
        touching = static_cast<float>(rounding / fastest);
        parallel = slowest < 2 * slowest_share * fastest;
    }
};

/// The rays in the cell's unit coordinates; returns those that meet it, a bit each. Rays in its
/// faces are left to the reference kernels.
inline std::uint64_t meet_entry_cell(SearchWorkspace& work, const SharedCell& cell,
                                     EntryRays& rays) {
    const hn::ScalableTag<float> d;
    using V = hn::VFromD<decltype(d)>;
    const RayPacket& packet = work.packet;
    const auto row = [&](std::size_t i) HWY_ATTR {
        return Lanes3<V>{hn::Set(d, static_cast<float>(cell.rows[3 * i])),
                         hn::Set(d, static_cast<float>(cell.rows[3 * i + 1])),
                         hn::Set(d, static_cast<float>(cell.rows[3 * i + 2]))};
    };
    const Lanes3<V> u_axis = row(0), v_axis = row(1), w_axis = row(2), middle = row(3);
    const V base = hn::Set(d, static_cast<float>(cell.base));
    const V room = hn::Set(d, entry_rounding);
    const PacketPace pace(packet, cell, static_cast<double>(entry_rounding));
    const V touching = hn::Set(d, cell.spheres ? 0.0F : pace.touching);
    std::uint64_t met = 0, in_face = 0;
    for (int i = 0; i < packet_rays; i += static_cast<int>(hn::Lanes(d))) {
        const V u1 = hn::LoadU(d, packet.u1 + i), v1 = hn::LoadU(d, packet.v1 + i);
        const V u = hn::Add(hn::LoadU(d, packet.u0 + i), hn::Mul(u1, base));
        const V v = hn::Add(hn::LoadU(d, packet.v0 + i), hn::Mul(v1, base));
        const Lanes3<V> o = add_scaled(add_scaled(middle, u, u_axis), v, v_axis);
        const Lanes3<V> s = add_scaled(add_scaled(w_axis, u1, u_axis), v1, v_axis);
        const LaneInterval<V> inside = cell.spheres ? in_unit_ball(d, o, s) : in_unit_cube(d, o, s);
        const V key = hn::Max(inside.key, hn::Sub(hn::LoadU(d, packet.start + i), base));
        store3(o, d, rays.origin[0] + i, packet_rays);
        store3(s, d, rays.direction[0] + i, packet_rays);
        hn::StoreU(key, d, rays.key + i);
        hn::StoreU(inside.exit, d, rays.exit + i);
        const V exit = hn::Add(inside.exit, touching);
        const auto here = hn::And(hn::Le(inside.key, exit), hn::Le(key, exit));
        if (!cell.spheres && pace.parallel) {
            in_face |= lane_bits(d, in_cube_face(d, o, s, {room, room, room})) << i;
        }
        met |= lane_bits(d, here) << i;
    }
    for (std::uint64_t rest = in_face & packet.inside; rest != 0; rest &= rest - 1) {
        leave_ray(work, std::countr_zero(rest));
    }
    return met & packet.inside & ~in_face;
}

/// A ray has found a cell below an entry cell, at that depth.
inline void note_found(SearchWorkspace& work, int ray, int start, double depth) {
    const auto at = static_cast<std::size_t>(ray);
    work.found[at].start = start;
    work.found[at].depth = depth;
    work.best[at] = work.packet.any_hit ? -beyond : depth;
    if (work.packet.any_hit) work.packet.inside &= ~(std::uint64_t{1} << ray);
    work.improved = true;
}

/// Gives an entry cell to the rays of the packet that meet it.
inline void visit_entry_cell(const WideScene& scene, SearchWorkspace& work, int index) {
    begin_looking(work);
    const SharedCell cell = work.cells[static_cast<std::size_t>(index)];
    const WideObject& object = scene.objects[static_cast<std::size_t>(cell.object)];
    EntryRays& rays = work.start;
    std::uint64_t met = meet_entry_cell(work, cell, rays);
    if (met == 0) return;
    alignas(64) float map[12 * table_step] = {};  // the identity, as a block of one lane
    for (const int i : {0, 4, 8}) map[i * table_step] = 1;
    float linear[9 * table_step] = {};
    for (std::size_t i = 0; i < 9; ++i) {
        linear[i * table_step] = static_cast<float>(cell.linear[i]);
    }
    const Opening opening{map,      linear,     table_step, static_cast<float>(cell.constant),
                          cell.set, cell.level, -1,         index};
    EntryChildren children{-1, object.levels};
    for (; met != 0; met &= met - 1) {
        const int i = std::countr_zero(met);
        const auto at = static_cast<std::size_t>(i);
        ++work.found[at].tested;
        const double key = cell.base + static_cast<double>(rays.key[i]);
        if (!(key < work.best[at])) continue;
        const auto pixel0 = static_cast<double>(work.packet.pixel0[i]);
        const auto growth = static_cast<double>(work.packet.pixel1[i]);
        const double p = pixel0 + growth * key;
        const bool last = cell.level == object.levels;
        if (last || cell.diameter <= scene.detail * std::max(p, object.smallest_pixel)) {
            work.found[at].block = work.found[at].below_count = -1;
            note_found(work, i, index, key);
            continue;
        }
        RayInEntry ray;
        for (int k = 0; k < 3; ++k) {
            ray.origin[k] = rays.origin[k][i];
            ray.direction[k] = rays.direction[k][i];
        }
        const float* s = ray.direction;
        ray.pixel_base = static_cast<float>(scene.detail * (pixel0 + growth * cell.base));
        ray.pixel_growth = static_cast<float>(scene.detail * growth);
        ray.pixel_least = static_cast<float>(scene.detail * object.smallest_pixel);
        ray.slack = 0x1p-20F / std::sqrt(s[0] * s[0] + s[1] * s[1] + s[2] * s[2]);
        ray.key = rays.key[i];
        ray.exit = rays.exit[i];
        ray.best = static_cast<float>(work.best[at] - cell.base);
        if (children.block < 0) children.block = make_block(scene, work, opening, object.levels);
        Found& found = work.found[at];
        const bool improved = follow_ray(scene, work, ray, children, found);
        if (found.given_up) {
            leave_ray(work, i);
        } else if (improved) {
            found.below_count = -1;
            const double depth = cell.base + static_cast<double>(ray.found);
            note_found(work, i, index, depth);
        }
    }
}

}  // namespace pxm::host::wide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
