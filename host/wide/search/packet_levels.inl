// The levels of the hierarchy that the rays of a packet share. The packet goes down as a whole, the
// nearest cell first, until a cell is no larger than a few pixels. All in double: this is where
// magnification costs digits. A cell is skipped only if no ray of the packet can meet it.
#if defined(PXM_HOST_WIDE_SEARCH_PACKET_LEVELS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PXM_HOST_WIDE_SEARCH_PACKET_LEVELS_INL
#undef PXM_HOST_WIDE_SEARCH_PACKET_LEVELS_INL
#else
#define PXM_HOST_WIDE_SEARCH_PACKET_LEVELS_INL
#endif

#include <hwy/highway.h>

#include <algorithm>

#include "host/wide/packet/lanes.inl"
#include "host/wide/search/packet_search.hpp"

HWY_BEFORE_NAMESPACE();
namespace pxm::host::wide::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Relative room for rounding: unit volumes are taken that much larger.
inline constexpr double unit_margin = 1e-6;
inline constexpr double beyond = 1e300;

/// Children of a shared cell in lanes: rows of the scratch table.
struct SharedRows {
    static constexpr int map = 0;  // 12: U, V, W, o
    static constexpr int base = 12;
    static constexpr int near = 13;
    static constexpr int far = 14;
    static constexpr int constant = 15;
    static constexpr int diameter = 16;
    static constexpr int linear = 17;  // 9
    static constexpr int count = 26;
};

template <class V>
struct Frustum {
    Lanes3<V> u, v, w, o;
    V base;
};

/// The depths at which any ray of the packet may be in the unit volume, within [near, far].
/// Half a cube's width grows by how far the rays are spread along each axis, which is linear in z:
/// c (z - base) <= q twice for each axis. A ball is cut out of its cube.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE LaneInterval<V> frustum_in_volume(D d, const RayPacket& packet,
                                             const Frustum<V>& frustum, bool spheres,
                                             LaneInterval<V> inside) {
    const V zero = hn::Zero(d);
    const V one = hn::Set(d, 1.0 + unit_margin);
    const V u0 = hn::Set(d, packet.reach_u0), u1 = hn::Set(d, packet.reach_u1);
    const V v0 = hn::Set(d, packet.reach_v0), v1 = hn::Set(d, packet.reach_v1);
    const auto clip = [&](V c, V q) HWY_ATTR {
        const V bound = hn::Add(hn::Div(q, c), frustum.base);
        const auto ahead = hn::Lt(zero, c);
        const auto behind = hn::Lt(c, zero);
        inside.exit = hn::IfThenElse(ahead, hn::Min(inside.exit, bound), inside.exit);
        inside.key = hn::IfThenElse(behind, hn::Max(inside.key, bound), inside.key);
    };
    const auto axis = [&](V o, V w, V u, V v) HWY_ATTR {
        const V wide0 = hn::Add(hn::Mul(hn::Abs(u), u0), hn::Mul(hn::Abs(v), v0));
        const V wide1 = hn::Add(hn::Mul(hn::Abs(u), u1), hn::Mul(hn::Abs(v), v1));
        const V half = hn::Add(one, hn::Add(wide0, hn::Mul(wide1, frustum.base)));
        clip(hn::Sub(w, wide1), hn::Sub(half, o));
        clip(hn::Sub(hn::Neg(w), wide1), hn::Add(half, o));
    };
    axis(frustum.o.x, frustum.w.x, frustum.u.x, frustum.v.x);
    axis(frustum.o.y, frustum.w.y, frustum.u.y, frustum.v.y);
    axis(frustum.o.z, frustum.w.z, frustum.u.z, frustum.v.z);
    if (!spheres) return inside;
    const V length_u = hn::Sqrt(dot(frustum.u, frustum.u));
    const V length_v = hn::Sqrt(dot(frustum.v, frustum.v));
    const V reach_u = hn::Add(u0, hn::Mul(u1, inside.exit));
    const V reach_v = hn::Add(v0, hn::Mul(v1, inside.exit));
    const V wide = hn::Add(hn::Mul(length_u, reach_u), hn::Mul(length_v, reach_v));
    const V radius = hn::Add(one, wide);
    const V chord2 = hn::Sub(hn::Mul(radius, radius), dot(frustum.o, frustum.o));  // o is the foot
    const V half = hn::Sqrt(hn::Div(hn::Max(chord2, zero), dot(frustum.w, frustum.w)));
    const auto misses = hn::Lt(chord2, zero);
    inside.key = hn::Max(inside.key, hn::Sub(frustum.base, half));
    inside.exit = hn::Min(inside.exit, hn::Add(frustum.base, half));
    inside.exit = hn::IfThenElse(misses, hn::Set(d, -beyond), inside.exit);
    return inside;
}

/// Moves o to the foot of the perpendicular from the volume's centre.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE void rebase(D d, Frustum<V>& frustum) {
    const V step = hn::Neg(
        hn::Div(dot(frustum.o, frustum.w), hn::Max(dot(frustum.w, frustum.w), hn::Set(d, 1e-200))));
    frustum.o = add_scaled(frustum.o, step, frustum.w);
    frustum.base = hn::Add(frustum.base, step);
}

/// p(z) at least, of all rays of the packet.
HWY_INLINE double pixel_at(const WideScene& scene, const RayPacket& packet, int object, double z) {
    const double p = packet.pixel_at_origin + packet.pixel_growth * z;
    return scene.detail *
           std::max(p, scene.objects[static_cast<std::size_t>(object)].smallest_pixel);
}

/// Puts a cell into the queue, nearest first.
inline void push_into_queue(SearchWorkspace& work, double near, int cell) {
    work.queue.emplace_back(near, cell);
    std::push_heap(work.queue.begin(), work.queue.end(), IsFarther{});
}

/// Makes a cell of a child whose rows are in the scratch, and puts it into the queue.
inline void push_shared_child(const WideSet& set, SearchWorkspace& work, int parent_index,
                              int lane) {
    const double* rows = work.scratch.get();
    const auto at = [&](int i) { return rows[static_cast<std::ptrdiff_t>(i) * set.stride + lane]; };
    SharedCell& child = work.cells.emplace_back();
    const SharedCell& parent = work.cells[static_cast<std::size_t>(parent_index)];
    for (int i = 0; i < 12; ++i) child.rows[static_cast<std::size_t>(i)] = at(i);
    if (set.polar) {
        for (int i = 0; i < 9; ++i) {
            child.linear[static_cast<std::size_t>(i)] = at(SharedRows::linear + i);
        }
    } else {
        child.constant = at(SharedRows::constant);
    }
    child.diameter = at(SharedRows::diameter);
    child.base = at(SharedRows::base);
    child.near = at(SharedRows::near);
    child.far = at(SharedRows::far);
    child.set = set.sets[static_cast<std::size_t>(lane)];
    child.object = parent.object;
    child.parent = parent_index;
    child.lane = lane;
    child.level = parent.level + 1;
    child.spheres = set.spheres;
    push_into_queue(work, child.near, static_cast<int>(work.cells.size()) - 1);
}

/// Puts the children of a shared cell into the queue that a ray of the packet may meet.
inline void open_shared_cell(const WideScene& scene, SearchWorkspace& work, int index) {
    const hn::ScalableTag<double> d;
    using V = hn::VFromD<decltype(d)>;
    const SharedCell parent = work.cells[static_cast<std::size_t>(index)];
    const WideSet& set = scene.sets[static_cast<std::size_t>(parent.set)];
    const int stride = set.stride;
    double* rows = work.scratch.get();
    const auto row = [&](int i) { return rows + static_cast<std::ptrdiff_t>(i) * stride; };
    work.shared_tests += static_cast<std::uint64_t>(set.count);
    for (int i = 0; i < set.count; i += static_cast<int>(hn::Lanes(d))) {
        const double* table = set.f64.row(0) + i;
        const Lanes3x3<V> k = load3x3(d, table, stride);
        Frustum<V> frustum;
        frustum.u = transform(broadcast(d, parent.rows.data()), k);
        frustum.v = transform(broadcast(d, parent.rows.data() + 3), k);
        frustum.w = transform(broadcast(d, parent.rows.data() + 6), k);
        frustum.o = add(transform(broadcast(d, parent.rows.data() + 9), k),
                        load3(d, table + ChildField::offset * stride, stride));
        frustum.base = hn::Set(d, parent.base);
        rebase(d, frustum);
        const LaneInterval<V> inside =
            frustum_in_volume(d, work.packet, frustum, set.spheres,
                              LaneInterval<V>{hn::Set(d, parent.near), hn::Set(d, parent.far)});
        store3(frustum.u, d, row(0) + i, stride);
        store3(frustum.v, d, row(3) + i, stride);
        store3(frustum.w, d, row(6) + i, stride);
        store3(frustum.o, d, row(9) + i, stride);
        hn::StoreU(frustum.base, d, row(SharedRows::base) + i);
        hn::StoreU(inside.key, d, row(SharedRows::near) + i);
        hn::StoreU(inside.exit, d, row(SharedRows::far) + i);
        const V diameter = hn::LoadU(d, table + ChildField::diameter * stride);
        if (set.polar) {
            const Lanes3x3<V> t = load3x3(d, table + ChildField::forward * stride, stride);
            const Lanes3x3<V> outer{{broadcast(d, parent.linear.data()),
                                     broadcast(d, parent.linear.data() + 3),
                                     broadcast(d, parent.linear.data() + 6)}};
            const Lanes3x3<V> linear{{transform(t.row[0], outer), transform(t.row[1], outer),
                                      transform(t.row[2], outer)}};
            for (int r = 0; r < 3; ++r) {
                store3(linear.row[r], d, row(SharedRows::linear + 3 * r) + i, stride);
            }
            hn::StoreU(hn::Mul(largest_singular_value(d, linear), diameter), d,
                       row(SharedRows::diameter) + i);
        } else {
            const V constant = hn::Mul(hn::LoadU(d, table + ChildField::constant * stride),
                                       hn::Set(d, parent.constant));
            hn::StoreU(constant, d, row(SharedRows::constant) + i);
            hn::StoreU(hn::Mul(constant, diameter), d, row(SharedRows::diameter) + i);
        }
    }
    for (int lane = 0; lane < set.count; ++lane) {
        if (row(SharedRows::near)[lane] <= row(SharedRows::far)[lane]) {
            push_shared_child(set, work, index, lane);
        }
    }
}

/// Step 1.1: the outermost cell of an object, if a ray of the packet may meet it.
inline void push_object(const WideScene& scene, SearchWorkspace& work, int index) {
    const hn::CappedTag<double, 1> d;
    using V = hn::VFromD<decltype(d)>;
    const WideObject& object = scene.objects[static_cast<std::size_t>(index)];
    SharedCell cell;
    const auto put = [&](std::size_t i, const glm::dvec3& v) {
        for (int k = 0; k < 3; ++k) cell.rows[3 * i + static_cast<std::size_t>(k)] = v[k];
    };
    for (std::size_t i = 0; i < 3; ++i) put(i, object.to_unit.direction(work.packet.axis[i]));
    const auto from = [&](std::size_t i) { return broadcast(d, cell.rows.data() + 3 * i); };
    Frustum<V> frustum{from(0), from(1), from(2), {}, hn::Zero(d)};
    const glm::dvec3 origin = object.to_unit.point(work.packet.origin);
    frustum.o = broadcast(d, &origin.x);
    rebase(d, frustum);
    const LaneInterval<V> inside = frustum_in_volume(
        d, work.packet, frustum, object.spheres, LaneInterval<V>{hn::Zero(d), hn::Set(d, beyond)});
    ++work.shared_tests;
    cell.near = hn::GetLane(inside.key);
    cell.far = hn::GetLane(inside.exit);
    if (!(cell.near <= cell.far)) return;
    put(3, {hn::GetLane(frustum.o.x), hn::GetLane(frustum.o.y), hn::GetLane(frustum.o.z)});
    cell.base = hn::GetLane(frustum.base);
    for (std::size_t i = 0; i < 9; ++i) {
        const auto r = static_cast<int>(i);
        cell.linear[i] = object.linear[r / 3][r % 3];
    }
    cell.constant = object.constant;
    cell.set = object.set;
    cell.object = index;
    cell.spheres = object.spheres;
    cell.diameter = object.constant * object.diameter;
    work.cells.push_back(cell);
    push_into_queue(work, cell.near, static_cast<int>(work.cells.size()) - 1);
}

}  // namespace pxm::host::wide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
