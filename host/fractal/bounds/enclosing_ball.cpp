#include "host/fractal/bounds/enclosing_ball.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

namespace pxm::host {

namespace {

constexpr double rounding = 1e-12;  // of the radius: a point this far outside is on the ball

/// Up to four points that are to lie on the ball.
struct Support {
    std::array<glm::dvec3, 4> points;
    int count = 0;
    [[nodiscard]] Support with(const glm::dvec3& point) const {
        Support more = *this;
        more.points[more.count++] = point;
        return more;
    }
};

/// The smallest ball that has all the points on its surface. Its centre is o = p0 + sum l_i (p_i -
/// p0) with 2 (p_i - p0) . (o - p0) = |p_i - p0|^2; for dependent points, the least solution.
Ball ball_through(const Support& support) {
    if (support.count == 0) return {};
    const glm::dvec3 origin = support.points[0];
    const int n = support.count - 1;
    Eigen::Matrix<double, Eigen::Dynamic, 3, 0, 3, 3> edges(n, 3);
    Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1> squares(n);
    for (int i = 0; i < n; ++i) {
        const glm::dvec3 edge = support.points[i + 1] - origin;
        edges.row(i) << edge.x, edge.y, edge.z;
        squares(i) = glm::dot(edge, edge) / 2;
    }
    if (n == 0) return {origin, 0};
    const Eigen::Vector3d offset = edges.completeOrthogonalDecomposition().solve(squares);
    const glm::dvec3 from_origin{offset(0), offset(1), offset(2)};
    return {origin + from_origin, glm::length(from_origin)};
}

bool contains(const Ball& ball, const glm::dvec3& point) {
    return glm::distance(ball.center, point) <= ball.radius * (1 + rounding);
}

/// Welzl's algorithm with the recursion on the support only, which is at most four points deep.
Ball smallest(Points& points, std::size_t count, const Support& support) {
    Ball ball = ball_through(support);
    if (support.count == 4) return ball;
    for (std::size_t i = 0; i < count; ++i) {
        if (support.count > 0 || i > 0) {
            if (contains(ball, points[i])) continue;
        }
        ball = smallest(points, i, support.with(points[i]));
        // Move to front: a point that mattered once is tried early.
        std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(i),
                    points.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    }
    return ball;
}

}  // namespace

Ball enclosing_ball(Points points) {
    Ball ball = smallest(points, points.size(), {});
    // Nearly dependent points can leave one outside by more than rounding.
    for (const glm::dvec3& point : points) {
        ball.radius = std::max(ball.radius, glm::distance(ball.center, point));
    }
    return ball;
}

}  // namespace pxm::host
