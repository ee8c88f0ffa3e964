// The rays of a tile, one in each lane: made when the first of its entry cells asks for them.
#if defined(PXM_HOST_WIDE_PACKET_PACKET_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PXM_HOST_WIDE_PACKET_PACKET_LANES_INL
#undef PXM_HOST_WIDE_PACKET_PACKET_LANES_INL
#else
#define PXM_HOST_WIDE_PACKET_PACKET_LANES_INL
#endif

#include <hwy/highway.h>

#include "host/wide/packet/ray_packet.hpp"

HWY_BEFORE_NAMESPACE();
namespace pxm::host::wide::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Fills in the lanes of a tile's rays.
inline void spread_rays(RayBundle& bundle) {
    const hn::CappedTag<double, tile_side> d;
    const hn::Rebind<float, decltype(d)> narrow;
    using V = hn::VFromD<decltype(d)>;
    if (bundle.is_spread) return;
    bundle.is_spread = true;
    const auto& fan = bundle.fan;
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0);
    for (int ray = 0; ray < bundle_rays; ray += static_cast<int>(hn::Lanes(d))) {
        const auto put = [&](V v, float* lanes)
                             HWY_ATTR { hn::StoreU(hn::DemoteTo(narrow, v), narrow, lanes + ray); };
        const V column = hn::Iota(d, ray % tile_side);
        const double row = ray / tile_side;
        const auto on_plane = [&](int axis) HWY_ATTR {
            const V first = hn::Set(d, fan.first[axis]);
            const V across = hn::Mul(hn::Set(d, fan.per_column[axis]), column);
            return hn::Add(hn::Add(first, across), hn::Set(d, fan.per_row[axis] * row));
        };
        V u = on_plane(0), v = on_plane(1);
        V stretch2 = one;
        if (bundle.perspective) {
            const V z = on_plane(2);
            u = hn::Div(u, z);
            v = hn::Div(v, z);
            stretch2 = hn::Add(one, hn::Add(hn::Mul(u, u), hn::Mul(v, v)));
        }
        const V length = hn::Sqrt(stretch2);
        put(bundle.perspective ? zero : u, bundle.u0);
        put(bundle.perspective ? zero : v, bundle.v0);
        put(bundle.perspective ? u : zero, bundle.u1);
        put(bundle.perspective ? v : zero, bundle.v1);
        put(length, bundle.stretch);
        put(hn::Div(one, stretch2), bundle.shrink2);
        put(zero, bundle.start);
        put(hn::Set(d, bundle.pixel_at_origin), bundle.pixel0);
        put(hn::Mul(hn::Set(d, bundle.pixel_growth), length), bundle.pixel1);
    }
}

}  // namespace pxm::host::wide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
