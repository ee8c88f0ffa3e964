#include "host/math/precise.hpp"

#include <algorithm>
#include <limits>

namespace pxm::host {

namespace {

PreciseVec3 cross(const PreciseVec3& a, const PreciseVec3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// x T
PreciseVec3 direction(const PreciseAffine& map, const PreciseVec3& x) {
    return add(add(scaled(map.linear[0], x[0]), scaled(map.linear[1], x[1])),
               scaled(map.linear[2], x[2]));
}

}  // namespace

bool is_long(const Decimal& decimal) {
    const std::string mantissa = decimal.text.substr(0, decimal.text.find_first_of("eE"));
    const auto digits =
        std::ranges::count_if(mantissa, [](char c) { return '0' <= c && c <= '9'; });
    return digits > std::numeric_limits<double>::max_digits10;
}

Precise precise(const Decimal& decimal) {
    return is_long(decimal) ? Precise(decimal.text) : Precise(decimal.value);
}

PreciseVec3 precise(const DecimalVec3& v) { return {precise(v[0]), precise(v[1]), precise(v[2])}; }

PreciseVec3 precise(const glm::dvec3& v) { return {Precise(v.x), Precise(v.y), Precise(v.z)}; }

PreciseAffine precise(const Affine& map) {
    return {{precise(map.linear[0]), precise(map.linear[1]), precise(map.linear[2])},
            precise(map.translation)};
}

double rounded(const Precise& x) { return x.convert_to<double>(); }

glm::dvec3 rounded(const PreciseVec3& v) { return {rounded(v[0]), rounded(v[1]), rounded(v[2])}; }

glm::dmat3 rounded_linear(const PreciseAffine& map) {
    return {rounded(map.linear[0]), rounded(map.linear[1]), rounded(map.linear[2])};
}

PreciseVec3 add(const PreciseVec3& a, const PreciseVec3& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

PreciseVec3 subtract(const PreciseVec3& a, const PreciseVec3& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

PreciseVec3 scaled(const PreciseVec3& v, const Precise& factor) {
    return {v[0] * factor, v[1] * factor, v[2] * factor};
}

Precise dot(const PreciseVec3& a, const PreciseVec3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

PreciseVec3 image(const PreciseAffine& map, const PreciseVec3& x) {
    return add(direction(map, x), map.translation);
}

PreciseAffine then(const PreciseAffine& first, const PreciseAffine& second) {
    return {{direction(second, first.linear[0]), direction(second, first.linear[1]),
             direction(second, first.linear[2])},
            image(second, first.translation)};
}

PreciseVec3 origin_of(const PreciseAffine& map) {
    // x T = -a by Cramer's rule: the rows of T are the columns of the equations.
    const PreciseVec3 b = scaled(map.translation, Precise(-1));
    const auto& [u, v, w] = map.linear;
    const Precise determinant = dot(u, cross(v, w));
    return {dot(b, cross(v, w)) / determinant, dot(u, cross(b, w)) / determinant,
            dot(u, cross(v, b)) / determinant};
}

PreciseVec3 fixed_point(const PreciseAffine& map) {
    PreciseAffine away = map;  // from where a point was to where it goes
    for (std::size_t i = 0; i < 3; ++i) away.linear[i][i] -= 1;
    return origin_of(away);
}

}  // namespace pxm::host
