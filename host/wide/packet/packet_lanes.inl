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
inline void spread_rays(RayPacket& packet) {
    const hn::CappedTag<double, tile_side> d;
    const hn::Rebind<float, decltype(d)> narrow;
    using V = hn::VFromD<decltype(d)>;
    if (packet.is_spread) return;
    packet.is_spread = true;
    const auto& fan = packet.fan;
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0);
    for (int ray = 0; ray < packet_rays; ray += static_cast<int>(hn::Lanes(d))) {
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
        if (packet.perspective) {
            const V z = on_plane(2);
            u = hn::Div(u, z);
            v = hn::Div(v, z);
            stretch2 = hn::Add(one, hn::Add(hn::Mul(u, u), hn::Mul(v, v)));
        }
        const V length = hn::Sqrt(stretch2);
        put(packet.perspective ? zero : u, packet.u0);
        put(packet.perspective ? zero : v, packet.v0);
        put(packet.perspective ? u : zero, packet.u1);
        put(packet.perspective ? v : zero, packet.v1);
        put(length, packet.stretch);
        put(hn::Div(one, stretch2), packet.shrink2);
        put(zero, packet.start);
        put(hn::Set(d, packet.pixel_at_origin), packet.pixel0);
        put(hn::Mul(hn::Set(d, packet.pixel_growth), length), packet.pixel1);
    }
}

}  // namespace pxm::host::wide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
