// Small vectors of lanes. Every product and every sum is rounded for itself, so that all register
// widths give the same numbers (design decision 9).
// A .inl file is compiled once for every target of Highway, with a guard that knows that.
#if defined(PXM_HOST_WIDE_PACKET_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PXM_HOST_WIDE_PACKET_LANES_INL
#undef PXM_HOST_WIDE_PACKET_LANES_INL
#else
#define PXM_HOST_WIDE_PACKET_LANES_INL
#endif

#include <hwy/highway.h>

#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace pxm::host::wide::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

template <class V>
struct Lanes3 {
    V x;
    V y;
    V z;
};

template <class V>
HWY_INLINE V dot(const Lanes3<V>& a, const Lanes3<V>& b) {
    return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}

/// a + s b
template <class V>
HWY_INLINE Lanes3<V> add_scaled(const Lanes3<V>& a, V s, const Lanes3<V>& b) {
    return {hn::Add(a.x, hn::Mul(s, b.x)), hn::Add(a.y, hn::Mul(s, b.y)),
            hn::Add(a.z, hn::Mul(s, b.z))};
}

template <class D, class T = hn::TFromD<D>, class V = hn::VFromD<D>>
HWY_INLINE Lanes3<V> broadcast(D d, const T* p) {
    return {hn::Set(d, p[0]), hn::Set(d, p[1]), hn::Set(d, p[2])};
}

/// Three rows of a table, `stride` apart, at a lane.
template <class D, class T = hn::TFromD<D>, class V = hn::VFromD<D>>
HWY_INLINE Lanes3<V> load3(D d, const T* rows, int stride) {
    return {hn::LoadU(d, rows), hn::LoadU(d, rows + stride), hn::LoadU(d, rows + 2 * stride)};
}

template <class D, class T = hn::TFromD<D>, class V = hn::VFromD<D>>
HWY_INLINE void store3(const Lanes3<V>& v, D d, T* rows, int stride) {
    hn::StoreU(v.x, d, rows);
    hn::StoreU(v.y, d, rows + stride);
    hn::StoreU(v.z, d, rows + 2 * stride);
}

/// A linear map in each lane, by rows.
template <class V>
struct Lanes3x3 {
    Lanes3<V> row[3];
};

template <class D, class T = hn::TFromD<D>, class V = hn::VFromD<D>>
HWY_INLINE Lanes3x3<V> load3x3(D d, const T* rows, int stride) {
    return {{load3(d, rows, stride), load3(d, rows + 3 * stride, stride),
             load3(d, rows + 6 * stride, stride)}};
}

/// x T, with row vectors.
template <class V>
HWY_INLINE Lanes3<V> transform(const Lanes3<V>& v, const Lanes3x3<V>& t) {
    const Lanes3<V> first{hn::Mul(v.x, t.row[0].x), hn::Mul(v.x, t.row[0].y),
                          hn::Mul(v.x, t.row[0].z)};
    return add_scaled(add_scaled(first, v.y, t.row[1]), v.z, t.row[2]);
}

template <class V>
HWY_INLINE Lanes3<V> add(const Lanes3<V>& a, const Lanes3<V>& b) {
    return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}

template <class V>
HWY_INLINE Lanes3<V> subtract(const Lanes3<V>& a, const Lanes3<V>& b) {
    return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}

template <class V>
HWY_INLINE V max3(V a, V b, V c) {
    return hn::Max(hn::Max(a, b), c);
}

/// The lanes of a mask, a bit each.
template <class D, class M>
HWY_INLINE std::uint64_t lane_bits(D d, M mask) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, mask, bytes);
    std::uint64_t bits = 0;
    constexpr int used = (static_cast<int>(hn::MaxLanes(D{})) + 7) / 8;
    for (int k = 0; k < used; ++k) bits |= std::uint64_t{bytes[k]} << (8 * k);
    return bits;
}

/// Part of a line, from key to exit.
template <class V>
struct LaneInterval {
    V key;
    V exit;
};

/// Where lines are in the unit ball; NaN where they are not (comparisons with NaN are false).
/// As in dsp_kernels/volume.hpp: from the closest approach, where few digits cancel.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE LaneInterval<V> in_unit_ball(D d, const Lanes3<V>& origin, const Lanes3<V>& direction) {
    const V length2 = dot(direction, direction);
    const V inverse = hn::Div(hn::Set(d, hn::TFromD<D>(1)), length2);
    const V step = hn::Neg(hn::Mul(dot(origin, direction), inverse));
    const Lanes3<V> foot = add_scaled(origin, step, direction);
    const V half_chord2 = hn::Sub(hn::Set(d, hn::TFromD<D>(1)), dot(foot, foot));
    const V half = hn::Sqrt(hn::Mul(half_chord2, inverse));
    return {hn::Sub(step, half), hn::Add(step, half)};
}

/// Where lines are in the cube [-1,1]^3: an interval that is empty where they are not.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE LaneInterval<V> in_unit_cube(D d, const Lanes3<V>& origin, const Lanes3<V>& direction) {
    using T = hn::TFromD<D>;
    const V one = hn::Set(d, T(1));
    const auto slab = [&](V o, V s) HWY_ATTR {
        const V speed = hn::IfThenElse(hn::Eq(s, hn::Zero(d)), hn::Set(d, T(1e-30)), s);
        const V inverse = hn::Div(one, speed);
        const V middle = hn::Neg(hn::Mul(o, inverse));
        const V half = hn::Abs(inverse);
        return LaneInterval<V>{hn::Sub(middle, half), hn::Add(middle, half)};
    };
    const LaneInterval<V> x = slab(origin.x, direction.x);
    const LaneInterval<V> y = slab(origin.y, direction.y);
    const LaneInterval<V> z = slab(origin.z, direction.z);
    return {max3(x.key, y.key, z.key), hn::Min(hn::Min(x.exit, y.exit), z.exit)};
}

/// A line that moves along an axis by less than this share of what it moves along another is seen
/// as parallel to the faces across that axis.
inline constexpr double slowest_share = 0x1p-10;

/// Lines that lie in a face of the cube [-1,1]^3, or so near to one that rounding decides whether
/// they are in the cube: within `room` of it while they pass.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE auto in_cube_face(D d, const Lanes3<V>& origin, const Lanes3<V>& direction,
                             const Lanes3<V>& room) {
    using T = hn::TFromD<D>;
    const Lanes3<V> speed{hn::Abs(direction.x), hn::Abs(direction.y), hn::Abs(direction.z)};
    const V fastest = max3(speed.x, speed.y, speed.z);
    const V slowest = hn::Mul(fastest, hn::Set(d, static_cast<T>(slowest_share)));
    const V passing = hn::Div(hn::Set(d, T(2)), fastest);  // the cube, from one face to another
    const auto axis = [&](V o, V s, V near) HWY_ATTR {
        const V from_face = hn::Abs(hn::Sub(hn::Abs(o), hn::Set(d, T(1))));
        const V drift = hn::Mul(s, passing);
        return hn::And(hn::Lt(s, slowest), hn::Le(from_face, hn::Add(near, drift)));
    };
    return hn::Or(hn::Or(axis(origin.x, speed.x, room.x), axis(origin.y, speed.y, room.y)),
                  axis(origin.z, speed.z, room.z));
}

/// The outward normal of the cube's face at depth t of the line, up to its length: the first axis
/// whose slab begins (ends) there.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE Lanes3<V> cube_normal(D d, const Lanes3<V>& origin, const Lanes3<V>& direction, V t) {
    // The coordinate that is farthest out where the line meets the surface.
    const Lanes3<V> place = add_scaled(origin, t, direction);
    const V x = hn::Abs(place.x), y = hn::Abs(place.y), z = hn::Abs(place.z);
    const auto is_x = hn::And(hn::Ge(x, y), hn::Ge(x, z));
    const auto is_y = hn::AndNot(is_x, hn::Ge(y, z));
    const auto is_z = hn::Not(hn::Or(is_x, is_y));
    (void)d;
    return {hn::IfThenElseZero(is_x, place.x), hn::IfThenElseZero(is_y, place.y),
            hn::IfThenElseZero(is_z, place.z)};
}

/// cos(acos(r) / 3) for r in [-1, 1]: the largest solution of 4 f^3 - 3 f = r.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE V cosine_of_third(D d, V r) {
    using T = hn::TFromD<D>;
    const V half = hn::Set(d, T(0.5));
    const V three = hn::Set(d, T(3));
    // Right at both ends, and with the right kind of slope at -1, where two solutions meet.
    V f = hn::Add(half, hn::Mul(half, hn::Sqrt(hn::Mul(half, hn::Add(hn::Set(d, T(1)), r)))));
    constexpr int newton_steps = 3;
    for (int i = 0; i < newton_steps; ++i) {
        const V square4 = hn::Mul(hn::Set(d, T(4)), hn::Mul(f, f));
        const V value = hn::Sub(hn::Mul(f, hn::Sub(square4, three)), r);
        const V slope = hn::Sub(hn::Mul(three, square4), three);
        f = hn::Sub(f, hn::Div(value, hn::Max(slope, hn::Set(d, T(1e-4)))));
    }
    return f;
}

/// The largest singular value of each lane's linear map: the root of the largest eigenvalue of
/// T T^t (Eq. 16.9), by the trigonometric solution of its characteristic equation.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE V largest_singular_value(D d, const Lanes3x3<V>& t) {
    using T = hn::TFromD<D>;
    const V one = hn::Set(d, T(1));
    const V tiny = hn::Set(d, T(1e-30));
    const V xx = dot(t.row[0], t.row[0]);
    const V yy = dot(t.row[1], t.row[1]);
    const V zz = dot(t.row[2], t.row[2]);
    const V trace = hn::Add(hn::Add(xx, yy), zz);
    const V scale = hn::Div(one, hn::Max(trace, hn::Set(d, T(1e-36))));  // deep zooms come near
    const auto scaled = [&](V a) HWY_ATTR { return hn::Mul(a, scale); };
    const V third = hn::Set(d, T(1.0 / 3));
    const V a = hn::Sub(scaled(xx), third);  // the matrix less a third of its trace
    const V b = hn::Sub(scaled(yy), third);
    const V c = hn::Sub(scaled(zz), third);
    const V xy = scaled(dot(t.row[0], t.row[1]));
    const V yz = scaled(dot(t.row[1], t.row[2]));
    const V zx = scaled(dot(t.row[2], t.row[0]));
    const V diagonal = dot(Lanes3<V>{a, b, c}, Lanes3<V>{a, b, c});
    const V aside = dot(Lanes3<V>{xy, yz, zx}, Lanes3<V>{xy, yz, zx});
    const V spread2 = hn::Mul(hn::Add(diagonal, hn::Add(aside, aside)), hn::Set(d, T(1.0 / 6)));
    const V spread = hn::Sqrt(hn::Max(spread2, tiny));
    const V a_minor = hn::Sub(hn::Mul(b, c), hn::Mul(yz, yz));
    const V xy_minor = hn::Sub(hn::Mul(yz, zx), hn::Mul(xy, c));
    const V zx_minor = hn::Sub(hn::Mul(xy, yz), hn::Mul(b, zx));
    const V determinant =
        hn::Add(hn::Add(hn::Mul(a, a_minor), hn::Mul(xy, xy_minor)), hn::Mul(zx, zx_minor));
    const V cube = hn::Mul(hn::Mul(spread, spread), spread);
    const V half = hn::Set(d, T(0.5));
    V r = hn::Mul(half, hn::Div(determinant, hn::Max(cube, tiny)));
    r = hn::Min(hn::Max(r, hn::Neg(one)), one);
    const V largest = hn::Add(third, hn::Mul(hn::Add(spread, spread), cosine_of_third(d, r)));
    return hn::Sqrt(hn::Mul(largest, trace));
}

}  // namespace pxm::host::wide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
