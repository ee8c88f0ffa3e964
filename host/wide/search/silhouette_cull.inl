// A cull for balls: all that can be seen of a cell lies in the convex hull of its attractor, and
// on the plane across the packet the hull's silhouette is a polygon. A ray that passes the polygon
// by more than a terminal cell's diameter meets no terminal ball inside, as each of them has a
// point of the attractor in it: the picture stays that of the balls (design decision 4).
// Conditions: homotheties of one follow set, whose hull is that of the maps' fixed points (h(n) =
// max_i r_i h(n) + n t_i has the solution max_i n x_i); a shadow of few edges that is much smaller
// than the ball's.
#if defined(PXM_HOST_WIDE_SEARCH_SILHOUETTE_CULL_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PXM_HOST_WIDE_SEARCH_SILHOUETTE_CULL_INL
#undef PXM_HOST_WIDE_SEARCH_SILHOUETTE_CULL_INL
#else
#define PXM_HOST_WIDE_SEARCH_SILHOUETTE_CULL_INL
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "host/wide/search/packet_search.hpp"

HWY_BEFORE_NAMESPACE();
namespace pxm::host::wide::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Twice the area of the triangle a, b, c, positive if it turns left.
inline double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The convex hull of `points` (sorted in place), counterclockwise, by Andrew's monotone chain.
inline int convex_hull(glm::dvec2* points, int count, glm::dvec2* hull) {
    std::sort(points, points + count, [](const glm::dvec2& a, const glm::dvec2& b) {
        return a.x < b.x || (a.x == b.x && a.y < b.y);
    });
    int size = 0;
    const auto chain = [&](int first, int last, int step, int least) {
        for (int i = first; i != last; i += step) {
            while (size >= least + 2 && turn(hull[size - 2], hull[size - 1], points[i]) <= 0)
                --size;
            hull[size++] = points[i];
        }
        --size;
    };
    chain(0, count, 1, 0);
    chain(count - 1, -1, -1, size);
    return size;
}

/// The silhouette of an object's hull in the packet's frame, in radii from the ball's centre.
inline SilhouetteCull make_silhouette_cull(const WideObject& object, const RayPacket& packet) {
    constexpr double largest_share = 0.75;  // of the ball's shadow; beyond it the cull costs more
    constexpr double pi = 3.14159265358979;
    SilhouetteCull shadow;
    const auto count = static_cast<int>(object.hull.size());
    if (count < 3) return shadow;
    std::array<glm::dvec2, WideObject::most_hull_points> points;
    std::array<glm::dvec2, WideObject::most_hull_points + 1> hull;
    const glm::dvec3 u = glm::normalize(object.to_unit.direction(packet.axis[0]));
    const glm::dvec3 v = glm::normalize(object.to_unit.direction(packet.axis[1]));
    for (int i = 0; i < count; ++i) {
        const glm::dvec3& point = object.hull[static_cast<std::size_t>(i)];
        points[static_cast<std::size_t>(i)] = {glm::dot(point, u), glm::dot(point, v)};
    }
    const int edges = convex_hull(points.data(), count, hull.data());
    if (edges < 3 || edges > SilhouetteCull::most_edges) return shadow;
    double area = 0;
    for (int i = 0; i < edges; ++i) {
        const glm::dvec2 a = hull[static_cast<std::size_t>(i)];
        const glm::dvec2 b = hull[static_cast<std::size_t>((i + 1) % edges)];
        area += (a.x * b.y - a.y * b.x) / 2;
        const glm::dvec2 out = glm::normalize(glm::dvec2{b.y - a.y, a.x - b.x});
        shadow.put(i, {out.x, out.y, glm::dot(out, a)});
    }
    if (area <= largest_share * pi) shadow.edges = edges;
    return shadow;
}

/// Of the rays that `met` a ball of radius r, those whose place beside its centre is in the shadow,
/// or no farther from each edge than `margin`. (x, y) is the centre seen from the ray.
template <class D, class V = hn::VFromD<D>, class M>
HWY_INLINE M in_silhouette(D d, const SilhouetteCull& shadow, V x, V y, V r, V margin, M met) {
    using T = hn::TFromD<D>;
    for (int i = 0; i < shadow.edges; ++i) {
        const auto& edge = shadow.template edge<T>(i);
        const V out = hn::Add(hn::Mul(x, hn::Set(d, edge.x)), hn::Mul(y, hn::Set(d, edge.y)));
        const V reach = hn::Add(hn::Mul(r, hn::Set(d, edge.height)), margin);
        met = hn::And(met, hn::Le(hn::Neg(reach), out));
    }
    return met;
}

}  // namespace pxm::host::wide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
