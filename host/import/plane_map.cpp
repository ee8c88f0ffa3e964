#include "host/import/plane_map.hpp"

#include <cmath>

#include "host/math/lipschitz.hpp"

namespace pxm::host {
namespace {

constexpr double point_thickness = 0.5;  // z scale of a map that squashes the plane to a point

}  // namespace

PlaneNumbers then(const PlaneNumbers& first, const PlaneNumbers& second) {
    return {second.a * first.a + second.b * first.c,
            second.a * first.b + second.b * first.d,
            second.c * first.a + second.d * first.c,
            second.c * first.b + second.d * first.d,
            second.a * first.e + second.b * first.f + second.e,
            second.c * first.e + second.d * first.f + second.f};
}

Affine plane_map(const PlaneNumbers& n) {
    Affine map;
    map.linear[0] = {n.a, n.c, 0};
    map.linear[1] = {n.b, n.d, 0};
    map.linear[2] = {0, 0, 0};
    map.translation = {n.e, n.f, 0};
    const double thickness = std::sqrt(std::abs(n.a * n.d - n.b * n.c));
    const double stretch = lipschitz_constant(map);
    map.linear[2][2] = thickness > 0 ? thickness : stretch > 0 ? stretch : point_thickness;
    return map;
}

}  // namespace pxm::host
