// The shared levels of an object whose maps are homotheties (Ch. 13): as packet_levels.inl, but a
// cell is a centre and a size. In double.
#if defined(PXM_HOST_WIDE_SEARCH_HOMOTHETY_LEVELS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PXM_HOST_WIDE_SEARCH_HOMOTHETY_LEVELS_INL
#undef PXM_HOST_WIDE_SEARCH_HOMOTHETY_LEVELS_INL
#else
#define PXM_HOST_WIDE_SEARCH_HOMOTHETY_LEVELS_INL
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>

#include "host/wide/search/packet_levels.inl"

HWY_BEFORE_NAMESPACE();
namespace pxm::host::wide::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The centres of a set's children in the packet's frame, in units of the cell's radius, made once
/// a packet.
inline const LaneTable<double>& turn_children(const WideScene& scene, SearchWorkspace& work,
                                              int object, int set) {
    const hn::ScalableTag<double> d;
    using V = hn::VFromD<decltype(d)>;
    const auto at = static_cast<std::size_t>(set);
    LaneTable<double>& turned = work.turned[at];
    const auto& first = scene.objects[static_cast<std::size_t>(object)];
    const std::uint64_t stamp =
        work.packet_number * scene.turns.size() + static_cast<std::uint64_t>(first.turn);
    if (work.turned_for[at] == stamp) return turned;
    work.turned_for[at] = stamp;
    const HomothetyTable& table = scene.sets[at].children;
    if (turned.empty()) turned = LaneTable<double>(3, table.stride);
    for (int axis = 0; axis < 3; ++axis) {
        const glm::dvec3 unit = glm::normalize(first.to_unit.direction(work.packet.axis[axis]));
        for (int i = 0; i < table.stride; i += static_cast<int>(hn::Lanes(d))) {
            const Lanes3<V> q = load3(d, table.f64.row(0) + i, table.stride);
            hn::StoreU(dot(q, broadcast(d, &unit.x)), d, turned.row(axis) + i);
        }
    }
    return turned;
}

/// The children of a cell of homotheties in lanes: rows of the scratch table.
struct HomothetyRows {
    static constexpr int center = 0;  // 3
    static constexpr int size = 3;
    static constexpr int near = 4;
    static constexpr int far = 5;
};

/// Rays that move sideways by (a, b) per depth.
template <class V>
struct Slant {
    V a, b;
    V shrink2;  // 1 / (1 + a^2 + b^2)
};

/// How slanting rays pass balls of radius r whose centres are (x, y) beside them at the centre's
/// depth.
template <class V>
struct BallPass {
    V ahead;  // depth of the foot of the perpendicular from the centre: rays are oblique
    V half2;  // the square of half the chord, negative on a miss

    HWY_INLINE BallPass(V x, V y, V r, const Slant<V>& rays) {
        const V slope = hn::Add(hn::Mul(rays.a, x), hn::Mul(rays.b, y));
        ahead = hn::Mul(slope, rays.shrink2);
        const V away2 = hn::Add(hn::Mul(x, x), hn::Mul(y, y));
        half2 = hn::Add(hn::Sub(hn::Mul(r, r), away2), hn::Mul(slope, ahead));
    }
    /// Half the depth between entry and exit; NaN on a miss.
    [[nodiscard]] HWY_INLINE V half(const Slant<V>& rays) const {
        return hn::Sqrt(hn::Mul(half2, rays.shrink2));
    }
};

/// detail * p(z) at most, of all rays of the packet.
inline double most_pixel_at(const WideScene& scene, const RayPacket& packet,
                            const WideObject& object, double z) {
    return std::max(scene.detail * object.smallest_pixel,
                    scene.detail * packet.most_at_origin + scene.detail * packet.most_growth * z);
}

/// A ball misses the frustum if its centre is farther beside the square of the rays than its
/// radius.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE LaneInterval<V> ball_in_frustum(D d, const RayPacket& packet, const Lanes3<V>& c, V r) {
    const V zero = hn::Zero(d);
    r = hn::Mul(r, hn::Set(d, 1 + unit_margin));
    const V far = hn::Add(c.z, r);
    const V reach_u =
        hn::Add(hn::Set(d, packet.reach_u0), hn::Mul(hn::Set(d, packet.reach_u1), far));
    const V reach_v =
        hn::Add(hn::Set(d, packet.reach_v0), hn::Mul(hn::Set(d, packet.reach_v1), far));
    const V x = hn::Max(hn::Sub(hn::Abs(c.x), reach_u), zero);
    const V y = hn::Max(hn::Sub(hn::Abs(c.y), reach_v), zero);
    const V half2 = hn::Sub(hn::Mul(r, r), hn::Add(hn::Mul(x, x), hn::Mul(y, y)));
    const auto met = hn::And(hn::Le(zero, half2), hn::Le(zero, far));
    const V half = hn::Sqrt(hn::Max(half2, zero));
    return {hn::Max(hn::Sub(c.z, half), zero),
            hn::IfThenElse(met, hn::Add(c.z, half), hn::Set(d, -beyond))};
}

/// The depths at which the rays may be in boxes: two bounds for each axis.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE LaneInterval<V> box_in_frustum(D d, const BoxFrustum& frustum, const Lanes3<V>& c,
                                          V half) {
    LaneInterval<V> inside{hn::Zero(d), hn::Set(d, beyond)};
    half = hn::Mul(half, hn::Set(d, 1 + unit_margin));
    const auto clip = [&](V reach, double pace) HWY_ATTR {
        const V bound = hn::Mul(reach, hn::Set(d, pace));
        if (pace > 0) {
            inside.exit = hn::Min(inside.exit, bound);
        } else {
            inside.key = hn::Max(inside.key, bound);
        }
    };
    const auto axis = [&](V center, std::size_t k) HWY_ATTR {
        const V wide = hn::Add(half, hn::Set(d, frustum.spread0[k]));
        const V from_eye = hn::Sub(center, hn::Set(d, frustum.eye[k]));
        clip(hn::Add(wide, from_eye), frustum.high_pace[k]);
        clip(hn::Sub(wide, from_eye), frustum.low_pace[k]);
    };
    axis(c.x, 0);
    axis(c.y, 1);
    axis(c.z, 2);
    return inside;
}

inline void push_homothety_cell(SearchWorkspace& work, const HomothetyCell& cell) {
    work.homothety_cells.push_back(cell);
    push_into_queue(work, cell.near, ~(static_cast<int>(work.homothety_cells.size()) - 1));
}

/// Makes a cell of a child whose rows are in the scratch, and puts it into the queue.
inline void push_homothety_child(const HomothetyTable& table, SearchWorkspace& work,
                                 const HomothetyCell& parent, int index, int lane) {
    const double* rows = work.scratch.get();
    const auto at = [&](int i) {
        return rows[static_cast<std::ptrdiff_t>(i) * table.stride + lane];
    };
    push_homothety_cell(work, {{at(0), at(1), at(2)},
                               at(HomothetyRows::size),
                               at(HomothetyRows::near),
                               at(HomothetyRows::far),
                               parent.constant * table.f64.row(HomothetyTable::constant)[lane],
                               parent.constant * table.f64.row(HomothetyTable::diameter)[lane],
                               table.sets[static_cast<std::size_t>(lane)],
                               parent.object,
                               index,
                               lane,
                               parent.level + 1,
                               -1});
}

/// Puts the children of a cell of homotheties into the queue that a ray of the packet may meet.
inline void open_homothety_cell(const WideScene& scene, SearchWorkspace& work, int index) {
    const hn::ScalableTag<double> d;
    using V = hn::VFromD<decltype(d)>;
    const HomothetyCell parent = work.homothety_cells[static_cast<std::size_t>(index)];
    const WideObject& object = scene.objects[static_cast<std::size_t>(parent.object)];
    const WideSet& set = scene.sets[static_cast<std::size_t>(parent.set)];
    const HomothetyTable& table = set.children;
    const LaneTable<double>& centers =
        object.spheres ? turn_children(scene, work, parent.object, parent.set) : table.f64;
    const BoxFrustum& frustum = work.box_frusta[static_cast<std::size_t>(parent.object)];
    double* rows = work.scratch.get();
    const auto row = [&](int i) { return rows + static_cast<std::ptrdiff_t>(i) * table.stride; };
    work.shared_tests += static_cast<std::uint64_t>(table.count);
    const V size = hn::Set(d, parent.size);
    for (int i = 0; i < table.count; i += static_cast<int>(hn::Lanes(d))) {
        const Lanes3<V> c = add_scaled(broadcast(d, parent.center.data()), size,
                                       load3(d, centers.row(0) + i, table.stride));
        const V half = hn::Mul(size, hn::LoadU(d, table.f64.row(HomothetyTable::scale) + i));
        const LaneInterval<V> inside = object.spheres ? ball_in_frustum(d, work.packet, c, half)
                                                      : box_in_frustum(d, frustum, c, half);
        store3(c, d, row(HomothetyRows::center) + i, table.stride);
        hn::StoreU(half, d, row(HomothetyRows::size) + i);
        const V near = hn::Max(inside.key, hn::Set(d, parent.near));
        const V far = hn::Min(inside.exit, hn::Set(d, parent.far));
        hn::StoreU(near, d, row(HomothetyRows::near) + i);
        hn::StoreU(far, d, row(HomothetyRows::far) + i);
        auto wanted = hn::And(hn::Le(near, far), hn::Lt(near, hn::Set(d, work.farthest)));
        wanted = hn::And(wanted, hn::FirstN(d, static_cast<std::size_t>(table.count - i)));
        for (std::uint64_t rest = lane_bits(d, wanted); rest != 0; rest &= rest - 1) {
            push_homothety_child(table, work, parent, index, i + std::countr_zero(rest));
        }
    }
}

inline void set_box_frustum(const WideObject& object, const RayPacket& packet,
                            BoxFrustum& frustum) {
    const glm::dvec3 u = object.to_unit.direction(packet.axis[0]);
    const glm::dvec3 v = object.to_unit.direction(packet.axis[1]);
    const glm::dvec3 w = object.to_unit.direction(packet.axis[2]);
    constexpr double least_pace = 1e-200;
    const auto inverse = [](double x) { return 1 / (std::abs(x) < least_pace ? least_pace : x); };
    const glm::dvec3 eye = object.to_unit.point(packet.origin);
    for (int k = 0; k < 3; ++k) {
        const auto at = static_cast<std::size_t>(k);
        const double spread1 = std::abs(u[k]) * packet.reach_u1 + std::abs(v[k]) * packet.reach_v1;
        frustum.eye[at] = eye[k];
        frustum.spread0[at] = std::abs(u[k]) * packet.reach_u0 + std::abs(v[k]) * packet.reach_v0;
        frustum.high_pace[at] = inverse(w[k] - spread1);
        frustum.low_pace[at] = inverse(-w[k] - spread1);
    }
}

/// Step 1.1 for an object of homotheties.
inline void push_homothety_object(const WideScene& scene, SearchWorkspace& work, int index) {
    const hn::CappedTag<double, 1> d;
    using V = hn::VFromD<decltype(d)>;
    const WideObject& object = scene.objects[static_cast<std::size_t>(index)];
    const RayPacket& packet = work.packet;
    HomothetyCell cell{{0, 0, 0},
                       1,
                       0,
                       beyond,
                       object.constant,
                       object.constant * object.diameter,
                       object.set,
                       index,
                       -1,
                       0,
                       0,
                       -1};
    if (object.spheres) {
        for (std::size_t k = 0; k < 3; ++k) {
            cell.center[k] = glm::dot(object.center - packet.origin, packet.axis[k]);
        }
        cell.size = object.radius;
    } else {
        set_box_frustum(object, packet, work.box_frusta[static_cast<std::size_t>(index)]);
    }
    const Lanes3<V> c = broadcast(d, cell.center.data());
    const V size = hn::Set(d, cell.size);
    const LaneInterval<V> inside =
        object.spheres
            ? ball_in_frustum(d, packet, c, size)
            : box_in_frustum(d, work.box_frusta[static_cast<std::size_t>(index)], c, size);
    ++work.shared_tests;
    cell.near = hn::GetLane(inside.key);
    cell.far = hn::GetLane(inside.exit);
    if (!(cell.near <= cell.far)) return;
    push_homothety_cell(work, cell);
}

/// A cell of homotheties in the form of other shared cells: the packet's frame to unit coordinates.
inline void rows_of(const WideObject& object, const RayPacket& packet, const HomothetyCell& cell,
                    std::array<double, 12>& rows, double& base) {
    const double shrink = (object.spheres ? object.radius : 1) / cell.size;
    glm::dvec3 axis[3];
    for (int i = 0; i < 3; ++i) axis[i] = object.to_unit.direction(packet.axis[i]) * shrink;
    glm::dvec3 o;
    if (object.spheres) {  // the centre is at z along the packet's axis, and beside it
        base = cell.center[2];
        o = -(axis[0] * cell.center[0] + axis[1] * cell.center[1]);
    } else {
        const glm::dvec3 center{cell.center[0], cell.center[1], cell.center[2]};
        o = (object.to_unit.point(packet.origin) - center) / cell.size;
        base = -glm::dot(o, axis[2]) / glm::dot(axis[2], axis[2]);
        o += base * axis[2];
    }
    for (int k = 0; k < 3; ++k) {
        for (int i = 0; i < 3; ++i) rows[static_cast<std::size_t>(3 * i + k)] = axis[i][k];
        rows[static_cast<std::size_t>(9 + k)] = o[k];
    }
}

}  // namespace pxm::host::wide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
