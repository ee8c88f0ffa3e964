// The cells around an object that was once a cell itself, for rays in lanes: as enclosing.cpp. In
// double: they are larger than what is seen by as much as the picture is magnified.
#if defined(PXM_HOST_WIDE_SHADE_ENCLOSING_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PXM_HOST_WIDE_SHADE_ENCLOSING_INL
#undef PXM_HOST_WIDE_SHADE_ENCLOSING_INL
#else
#define PXM_HOST_WIDE_SHADE_ENCLOSING_INL
#endif

#include <hwy/highway.h>

#include "host/wide/shade/enclosing.hpp"
#include "host/wide/shade/normal_sum.inl"
#include "host/wide/shade/path_levels.inl"

HWY_BEFORE_NAMESPACE();
namespace pxm::host::wide::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Rays in the coordinates of a cell around the object, `u`, `v` and `w` the packet's axes there.
template <class V>
struct AroundRays {
    Lanes3<V> u, v, w;
    Lanes3<V> origin, way;
    V start;  // the depth at which they begin
};

template <class D, class V = hn::VFromD<D>>
HWY_INLINE AroundRays<V> rays_around(D d, const CompiledEnclosure& cell, const RayPacket& packet,
                                     const BesideAxis<V>& rays, V start) {
    const auto axis = [&](int i) HWY_ATTR {
        const glm::dvec3 turned = cell.inverse.direction(packet.axis[i]);
        return broadcast(d, &turned.x);
    };
    const glm::dvec3 from = cell.inverse.point(packet.origin);
    AroundRays<V> result;
    result.u = axis(0);
    result.v = axis(1);
    result.w = axis(2);
    result.origin =
        add_scaled(add_scaled(broadcast(d, &from.x), rays.u0, result.u), rays.v0, result.v);
    result.way = add_scaled(add_scaled(result.w, rays.u1, result.u), rays.v1, result.v);
    result.start = start;
    return result;
}

/// Where rays enter a cell, and the outward normal there, of any length.
template <class V, class M>
struct AroundHits {
    V depth;
    Lanes3<V> normal;
    M met;
};

template <class D, class V = hn::VFromD<D>>
HWY_INLINE auto enter_ball(D d, const CompiledVolume& ball, const AroundRays<V>& rays) {
    const V none = hn::Zero(d);
    const Lanes3<V> center = broadcast(d, &ball.center.x);
    const V radius = hn::Set(d, ball.radius);
    const Lanes3<V> from_center = subtract(rays.origin, center);
    const V outside = hn::Sub(dot(from_center, from_center), hn::Mul(radius, radius));
    const V along = hn::Neg(dot(from_center, rays.way));
    const V chord2 = hn::Sub(hn::Mul(along, along), hn::Mul(dot(rays.way, rays.way), outside));
    const V depth = hn::Div(outside, hn::Add(along, hn::Sqrt(hn::Max(chord2, none))));
    const auto met =
        hn::And(hn::Lt(none, chord2), hn::And(hn::Lt(none, along), hn::Lt(none, outside)));
    return AroundHits<V, hn::Mask<D>>{depth, add_scaled(from_center, depth, rays.way), met};
}

/// Cells with flat sides: the points with normal . x <= offset for each.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE auto enter_sides(D d, const CompiledVolume& volume, const AroundRays<V>& rays) {
    const V none = hn::Zero(d);
    V entry = hn::Set(d, -beyond), exit = hn::Set(d, beyond);
    Lanes3<V> normal{none, none, none};
    const auto clip = [&](const glm::dvec3& side, double offset) HWY_ATTR {
        const Lanes3<V> face = broadcast(d, &side.x);
        const V slope = dot(face, rays.way);
        const V at = hn::Div(hn::Sub(hn::Set(d, offset), dot(face, rays.origin)), slope);
        exit = hn::IfThenElse(hn::Lt(none, slope), hn::Min(exit, at), exit);
        const auto later = hn::And(hn::Lt(slope, none), hn::Lt(entry, at));
        entry = hn::IfThenElse(later, at, entry);
        normal = {hn::IfThenElse(later, face.x, normal.x), hn::IfThenElse(later, face.y, normal.y),
                  hn::IfThenElse(later, face.z, normal.z)};
    };
    for (const HalfSpace& side : volume.half_spaces) clip(side.normal, side.offset);
    if (volume.kind == kernels::Volume::box) {
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 face{0};
            face[axis] = 1;
            clip(face, volume.high[axis]);
            clip(-face, -volume.low[axis]);
        }
    }
    return AroundHits<V, hn::Mask<D>>{entry, normal, hn::Le(entry, exit)};
}

/// Sums of what cells around an object give: HitLanes::enclosing.
template <class V>
struct EnclosingSums {
    Lanes3<V> weighted, plain;
    V total;
};

/// Adds the normals of the rays that enter a cell behind their start.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE void add_around(D d, const CompiledEnclosure& cell, const AroundRays<V>& rays,
                           double weight, EnclosingSums<V>& sums) {
    const auto hit = cell.volume.kind == kernels::Volume::sphere
                         ? enter_ball(d, cell.volume, rays)
                         : enter_sides(d, cell.volume, rays);
    const auto gives = hn::And(hit.met, hn::Lt(rays.start, hit.depth));
    // Normals go through the transpose of the inverse, and into the packet's frame.
    const Lanes3<V> seen{dot(hit.normal, rays.u), dot(hit.normal, rays.v), dot(hit.normal, rays.w)};
    const V scale = hn::Div(hn::Set(d, 1.0), hn::Sqrt(dot(seen, seen)));
    const Lanes3<V> normal{hn::IfThenElseZero(gives, hn::Mul(seen.x, scale)),
                           hn::IfThenElseZero(gives, hn::Mul(seen.y, scale)),
                           hn::IfThenElseZero(gives, hn::Mul(seen.z, scale))};
    sums.weighted = add_scaled(sums.weighted, hn::Set(d, weight), normal);
    sums.plain = add(sums.plain, normal);
    sums.total = hn::Add(sums.total, hn::IfThenElseZero(gives, hn::Set(d, weight)));
}

/// What the cells around the object give to the rays.
inline void take_enclosing(const WideScene& scene, const WideObject& object,
                           const RayPacket& packet, const PathWeights& weights, HitLanes& t) {
    const hn::CappedTag<double, HitLanes::most_lanes> d;
    using V = hn::VFromD<decltype(d)>;
    const V none = hn::Zero(d);
    for (int lane = 0; lane < t.count; lane += static_cast<int>(hn::Lanes(d))) {
        const BesideAxis<V> beside = rays_beside(d, t, lane);
        const V start = load_floats(d, t.begin + lane);
        EnclosingSums<V> sums{{none, none, none}, {none, none, none}, none};
        for (int at = object.enclosing; at >= 0;) {
            const CompiledEnclosure& cell = scene.enclosures[static_cast<std::size_t>(at)];
            const float weight = weights.of(static_cast<float>(cell.volume.diameter));
            add_around(d, cell, rays_around(d, cell, packet, beside, start),
                       static_cast<double>(weight), sums);
            at = cell.enclosing;
        }
        const V rows[7] = {sums.weighted.x, sums.weighted.y, sums.weighted.z, sums.plain.x,
                           sums.plain.y,    sums.plain.z,    sums.total};
        for (int i = 0; i < 7; ++i) put_hits(d, rows[i], t.enclosing[i] + lane);
    }
}

}  // namespace pxm::host::wide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
