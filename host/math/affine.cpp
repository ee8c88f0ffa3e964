#include "host/math/affine.hpp"

#include <cmath>
#include <glm/matrix.hpp>
#include <numbers>

namespace pxm::host {

Affine inverse(const Affine& map) {
    Affine result;
    result.linear = glm::inverse(map.linear);
    result.translation = -(result.linear * map.translation);
    return result;
}

double determinant(const Affine& map) { return glm::determinant(map.linear); }

Affine scaling(const glm::dvec3& factors) {
    Affine result;
    for (int i = 0; i < 3; ++i) result.linear[i][i] = factors[i];
    return result;
}

Affine translation(const glm::dvec3& offset) { return {glm::dmat3{1.0}, offset}; }

Affine rotation(Axis axis, double degrees) {
    // Quarter turns are exact: cos 90 is zero, not 6e-17.
    const double turned = std::remainder(degrees, 360.0);
    const double radians = turned * std::numbers::pi / 180.0;
    double c = std::cos(radians);
    double s = std::sin(radians);
    if (std::remainder(turned, 90.0) == 0.0) {
        c = std::round(c);
        s = std::round(s);
    }
    // `axis` turns the next axis toward the one after it: x: y to z, y: z to x, z: x to y.
    const int i = (static_cast<int>(axis) + 1) % 3;
    const int j = (static_cast<int>(axis) + 2) % 3;
    Affine result;
    result.linear[i][i] = c;
    result.linear[i][j] = s;
    result.linear[j][i] = -s;
    result.linear[j][j] = c;
    return result;
}

}  // namespace pxm::host
