#include "host/fractal/bounds/oriented_box.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "host/math/bracket_matrix.hpp"
#include "host/math/rounding.hpp"
#include "host/math/spectrum.hpp"

namespace pxm::host {

double support(const OrientedBox& box, const glm::dvec3& u) {
    double reach = glm::dot(u, box.center);
    for (const glm::dvec3& half : box.half) reach += std::abs(glm::dot(u, half));
    return reach;
}

glm::dmat3 principal_axes(const Points& points) {
    glm::dvec3 mean{0.0};
    for (const glm::dvec3& point : points) mean += point / static_cast<double>(points.size());
    glm::dmat3 spread{0.0};
    for (const glm::dvec3& point : points) spread += glm::outerProduct(point - mean, point - mean);
    const double trace = spread[0][0] + (spread[1][1] + spread[2][2]);
    if (!(trace > 0) || !std::isfinite(trace)) return glm::dmat3{1.0};
    return symmetric_axes(spread / trace).value_or(glm::dmat3{1.0});
}

OrientedBox oriented_box(const glm::dmat3& axes, const glm::dvec3& low, const glm::dvec3& high) {
    OrientedBox box;
    box.center = axes * ((low + high) / 2.0);
    for (int i = 0; i < 3; ++i) box.half[i] = axes[i] * ((high[i] - low[i]) / 2);
    return box;
}

double shortfall_along(const glm::dmat3& axes, const glm::dvec3& low, const glm::dvec3& high,
                       const glm::dvec3& places) {
    // x = A A^T x + (I - A A^T) x; the former is in the box.
    const BracketMatrix product = BracketMatrix{axes} * BracketMatrix{glm::transpose(axes)};
    double askew = 0;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            const Bracket rest =
                product[i][static_cast<std::size_t>(j)] - Bracket{i == j ? 1.0 : 0.0};
            askew = std::max(askew, rest.magnitude());
        }
    }
    return 2 * askew * sum_of_parts(places) +
           3 * rounding_of(sum_of_parts(low) + sum_of_parts(high));
}

}  // namespace pxm::host
