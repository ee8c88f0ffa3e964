#include "host/fractal/bounds/enclosing_ball.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <random>

namespace pxm::host {
namespace {

Points random_points(unsigned seed, int count) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    Points points;
    for (int i = 0; i < count; ++i)
        points.push_back({normal(random), normal(random), normal(random)});
    return points;
}

TEST(EnclosingBall, contains_all_points) {
    for (unsigned seed = 0; seed < 100; ++seed) {
        const Points points = random_points(seed, 1 + static_cast<int>(seed % 40));
        const Ball ball = enclosing_ball(points);
        for (const glm::dvec3& point : points) {
            EXPECT_LE(glm::distance(point, ball.center), ball.radius * (1 + 1e-12)) << seed;
        }
    }
}

// A ball is the smallest if no move of its centre brings all the farthest points nearer: its centre
// lies in the hull of the points on its surface, so each direction has one of them not behind it.
TEST(EnclosingBall, no_smaller_ball_does) {
    for (unsigned seed = 0; seed < 100; ++seed) {
        const Points points = random_points(seed, 2 + static_cast<int>(seed % 40));
        const Ball ball = enclosing_ball(points);
        for (const glm::dvec3& u : random_points(seed + 1000, 50)) {
            bool held = false;
            for (const glm::dvec3& point : points) {
                const glm::dvec3 arm = point - ball.center;
                held = held ||
                       (glm::length(arm) > ball.radius * (1 - 1e-9) && glm::dot(arm, u) > -1e-6);
            }
            EXPECT_TRUE(held) << seed;
        }
    }
}

TEST(EnclosingBall, of_a_cube_passes_through_its_corners) {
    Points points;
    for (int i = 0; i < 8; ++i) points.push_back({i & 1, i >> 1 & 1, i >> 2 & 1});
    const Ball ball = enclosing_ball(points);
    EXPECT_NEAR(ball.radius, std::sqrt(3.0) / 2, 1e-12);
    EXPECT_LT(glm::distance(ball.center, glm::dvec3{0.5}), 1e-12);
}

TEST(EnclosingBall, of_points_on_a_line_is_their_span) {
    Points points;
    for (int i = 0; i <= 10; ++i) points.push_back(glm::dvec3{1, 2, 3} * (i / 10.0));
    EXPECT_NEAR(enclosing_ball(points).radius, std::sqrt(14.0) / 2, 1e-12);
}

TEST(EnclosingBall, of_equal_points_is_a_point) {
    const Ball ball = enclosing_ball({{1, 2, 3}, {1, 2, 3}});
    EXPECT_EQ(ball.radius, 0);
    EXPECT_EQ(ball.center, (glm::dvec3{1, 2, 3}));
}

}  // namespace
}  // namespace pxm::host
