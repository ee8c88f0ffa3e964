// A cell of homotheties and one ray: which of the children in lanes it meets, and where (Ch. 13).
// The ray's direction is the same in all cells, so a child is met if a circle, or three intervals,
// say so.
#if defined(PXM_HOST_WIDE_FIXED_RAYS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PXM_HOST_WIDE_FIXED_RAYS_INL
#undef PXM_HOST_WIDE_FIXED_RAYS_INL
#else
#define PXM_HOST_WIDE_FIXED_RAYS_INL
#endif

#include <hwy/highway.h>

#include <cmath>
#include <limits>

#include "host/wide/hull_shadow.inl"
#include "host/wide/single_ray.inl"

HWY_BEFORE_NAMESPACE();
namespace pxm::host::wide::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// What a ray needs to know of p and of itself, whatever the volumes. Depths are in units of
/// `length` from the start cell's base.
struct FixedRay {
    float pixel_base;
    float pixel_growth;
    float pixel_least;
    float start;      // where the ray begins: keys are no less
    float best;       // no cell beyond is of interest
    float found = 0;  // depth of the terminal cell found

    [[nodiscard]] float pixel(float depth) const {
        return std::max(pixel_base + pixel_growth * depth, pixel_least);
    }
};

/// Children that a ray meets: depth and lane, terminal_bit as elsewhere.
struct MetLanes {
    alignas(64) float keys[most_children + register_room];
    alignas(64) std::int32_t lanes[most_children + register_room];
    int count = 0;
};

/// Keeps the lanes that are met, not before the ray's start and nearer than the best.
template <class D, class V = hn::VFromD<D>, class M>
HWY_INLINE void keep(D d, const FixedRay& ray, const HomothetyTable& table, int i, float constant,
                     bool last, V key, V exit, M met, MetLanes& found) {
    const hn::RebindToSigned<D> di;
    key = hn::Max(key, hn::Set(d, ray.start));
    met = hn::And(met, hn::And(hn::Le(key, exit), hn::Lt(key, hn::Set(d, ray.best))));
    met = hn::And(met, hn::FirstN(d, static_cast<std::size_t>(table.count - i)));
    if (hn::AllFalse(d, met)) return;
    const V p =
        hn::Max(hn::Add(hn::Set(d, ray.pixel_base), hn::Mul(hn::Set(d, ray.pixel_growth), key)),
                hn::Set(d, ray.pixel_least));
    const V diameter =
        hn::Mul(hn::Set(d, constant), hn::LoadU(d, table.rows.row(HomothetyTable::diameter) + i));
    const auto terminal = last ? hn::FirstN(d, hn::Lanes(d)) : hn::Le(diameter, p);
    const auto lane = hn::Or(hn::Iota(di, i), hn::IfThenElseZero(hn::RebindMask(di, terminal),
                                                                 hn::Set(di, terminal_bit)));
    hn::StoreU(hn::Compress(key, met), d, found.keys + found.count);
    hn::StoreU(hn::Compress(lane, hn::RebindMask(di, met)), di, found.lanes + found.count);
    found.count += static_cast<int>(hn::CountTrue(d, met));
}

/// Balls: lengths in units of the start cell's radius, (x, y) beside the ray at the centre's depth.
struct BallRay : FixedRay {
    float a;  // the ray moves sideways by (a, b) per depth
    float b;
    float shrink2;     // 1 / (1 + a^2 + b^2)
    float per_length;  // 1 / length, from scene units
    const HullShadow* shadow;

    /// `turned`: the table's centres in the bundle's frame.
    HWY_INLINE void meet(const Opened& cell, const HomothetyTable& table,
                         const LaneTable<float>& turned, bool last, MetLanes& met) const {
        const hn::ScalableTag<float> d;
        using V = hn::VFromD<decltype(d)>;
        const V va = hn::Set(d, a), vb = hn::Set(d, b), shrink = hn::Set(d, shrink2);
        const V size = hn::Set(d, cell.size);
        met.count = 0;
        const float beside = cell.size * (std::abs(a) + std::abs(b));
        const V margin = hn::Set(d, pixel(deepest(cell)) * per_length + beside);
        for (int i = 0; i < table.count; i += static_cast<int>(hn::Lanes(d))) {
            const Lanes3<V> q = load3(d, turned.row(0) + i, table.stride);
            const V beside_x = hn::Sub(q.x, hn::Mul(va, q.z));
            const V beside_y = hn::Sub(q.y, hn::Mul(vb, q.z));
            const V x = hn::Add(hn::Set(d, cell.x), hn::Mul(size, beside_x));
            const V y = hn::Add(hn::Set(d, cell.y), hn::Mul(size, beside_y));
            const V z = hn::Add(hn::Set(d, cell.z), hn::Mul(size, q.z));
            const V r = hn::Mul(size, hn::LoadU(d, table.rows.row(HomothetyTable::scale) + i));
            // The foot of the perpendicular is a little off the centre's depth: rays are oblique.
            const V slope = hn::Add(hn::Mul(va, x), hn::Mul(vb, y));
            const V ahead = hn::Mul(slope, shrink);
            const V away2 = hn::Add(hn::Mul(x, x), hn::Mul(y, y));
            const V half2 = hn::Add(hn::Sub(hn::Mul(r, r), away2), hn::Mul(slope, ahead));
            const auto inside = in_shadow(d, *shadow, x, y, r, margin, hn::Le(hn::Zero(d), half2));
            if (hn::AllFalse(d, inside)) continue;
            const V half = hn::Sqrt(hn::Mul(half2, shrink));
            const V middle = hn::Add(z, ahead);
            keep(d, *this, table, i, cell.constant, last, hn::Sub(middle, half),
                 hn::Add(middle, half), inside, met);
        }
    }
    /// The cell in a lane.
    HWY_INLINE void place(const Opened& cell, const HomothetyTable& table,
                          const LaneTable<float>& turned, int lane, Opened& child) const {
        const float qz = turned.row(2)[lane];
        child.x = cell.x + cell.size * (turned.row(0)[lane] - a * qz);
        child.y = cell.y + cell.size * (turned.row(1)[lane] - b * qz);
        child.z = cell.z + cell.size * qz;
        child.size = cell.size * table.rows.row(HomothetyTable::scale)[lane];
    }
    /// Not less than the key of any cell inside.
    [[nodiscard]] float deepest(const Opened& cell) const { return cell.z + 1.5F * cell.size; }
};

/// Boxes: x, y, z are the depths at which the ray passes the centre's three planes.
struct BoxRay : FixedRay {
    float pace[3];  // depth per unit of each axis

    HWY_INLINE void meet(const Opened& cell, const HomothetyTable& table,
                         const LaneTable<float>& /*turned*/, bool last, MetLanes& met) const {
        const hn::ScalableTag<float> d;
        using V = hn::VFromD<decltype(d)>;
        const float c[3] = {cell.x, cell.y, cell.z};
        met.count = 0;
        for (int i = 0; i < table.count; i += static_cast<int>(hn::Lanes(d))) {
            const V size = hn::Mul(hn::Set(d, cell.size),
                                   hn::LoadU(d, table.rows.row(HomothetyTable::scale) + i));
            const auto slab = [&](int k) HWY_ATTR {
                const V q = hn::LoadU(d, table.rows.row(k) + i);
                const V middle =
                    hn::Add(hn::Set(d, c[k]), hn::Mul(hn::Set(d, cell.size * pace[k]), q));
                const V half = hn::Mul(size, hn::Set(d, std::abs(pace[k])));
                return LaneInterval<V>{hn::Sub(middle, half), hn::Add(middle, half)};
            };
            const LaneInterval<V> x = slab(0), y = slab(1), z = slab(2);
            const V key = max3(x.key, y.key, z.key);
            const V exit = hn::Min(hn::Min(x.exit, y.exit), z.exit);
            keep(d, *this, table, i, cell.constant, last, key, exit, hn::Le(key, exit), met);
        }
    }
    HWY_INLINE void place(const Opened& cell, const HomothetyTable& table,
                          const LaneTable<float>& /*turned*/, int lane, Opened& child) const {
        child.x = cell.x + cell.size * pace[0] * table.rows.row(0)[lane];
        child.y = cell.y + cell.size * pace[1] * table.rows.row(1)[lane];
        child.z = cell.z + cell.size * pace[2] * table.rows.row(2)[lane];
        child.size = cell.size * table.rows.row(HomothetyTable::scale)[lane];
    }
    [[nodiscard]] float deepest(const Opened& cell) const {
        float exit = std::numeric_limits<float>::infinity();
        const float c[3] = {cell.x, cell.y, cell.z};
        for (int k = 0; k < 3; ++k) exit = std::min(exit, c[k] + cell.size * std::abs(pace[k]));
        return exit;
    }
};

}  // namespace pxm::host::wide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
