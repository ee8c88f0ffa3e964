#include "host/fractal/bounds/support_grid.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <random>

#include "tests/host/fractal/systems.hpp"

namespace pxm::host {
namespace {

glm::dvec3 random_vector(std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    return {normal(random), normal(random), normal(random)};
}

TEST(SupportGrid, a_direction_is_the_sum_of_the_corners_of_its_place) {
    std::mt19937_64 random(1);
    for (const int steps : {1, 2, 5, 16}) {
        const DirectionGrid grid(steps);
        for (int i = 0; i < 1000; ++i) {
            glm::dvec3 u = random_vector(random);
            if (i % 5 == 0) u[i % 3] = 0;  // on the rim of an octant
            const auto [corner, weight] = grid.locate(u);
            glm::dvec3 sum{0.0};
            for (int k = 0; k < 3; ++k) {
                EXPECT_GE(weight[k], 0);
                EXPECT_TRUE(weight[k] < 1e-12 || grid.is_point(corner[k]));
                sum += weight[k] * grid.point(corner[k]);
            }
            EXPECT_LT(glm::distance(sum, u), 1e-12) << steps;
        }
    }
}

TEST(SupportGrid, a_grid_point_is_its_own_place) {
    const DirectionGrid grid(6);
    int points = 0;
    for (int i = 0; i < grid.size(); ++i) {
        if (!grid.is_point(i)) continue;
        ++points;
        const auto [corner, weight] = grid.locate(grid.point(i));
        for (int k = 0; k < 3; ++k) {
            EXPECT_NEAR(weight[k], corner[k] == i ? 1 : 0, 1e-12);
        }
    }
    EXPECT_EQ(points, 4 * 6 * 6 + 2);
}

TEST(SupportGrid, bulge_is_the_most_that_interpolation_adds_to_a_ball) {
    std::mt19937_64 random(2);
    for (const int steps : {1, 4, 16}) {
        SupportGrid grid(steps, {glm::dvec3{0.0}}, {1});
        const DirectionGrid& directions = grid.directions();
        for (int i = 0; i < directions.size(); ++i) {
            grid.set_value(0, i, {glm::length(directions.point(i)), 0});
        }
        double largest = 0;
        for (int i = 0; i < 20'000; ++i) {
            const glm::dvec3 u = glm::normalize(random_vector(random));
            const double reach = grid.support(0, u);
            EXPECT_GE(reach, 1 - 1e-12);
            largest = std::max(largest, reach);
        }
        EXPECT_LE(largest, directions.bulge() * (1 + 1e-12));
        EXPECT_GE(largest - 1, 0.8 * (directions.bulge() - 1));
    }
}

TEST(SupportGrid, iteration_never_cuts_the_attractor) {
    std::mt19937_64 random(3);
    for (unsigned seed = 0; seed < 12; ++seed) {
        const Rifs rifs = systems::random_system(seed, 0.8);
        const std::size_t sets = rifs.follow_sets.size();
        SupportGrid grid(8, std::vector<glm::dvec3>(sets, glm::dvec3{0.0}),
                         std::vector<double>(sets, 8.7));
        const DirectionGrid& directions = grid.directions();
        for (std::size_t s = 0; s < rifs.follow_sets.size(); ++s) {
            for (int i = 0; i < directions.size(); ++i) {
                // The ball of radius sqrt(3) / (1 - 0.8) about the origin contains everything.
                const double reach = 8.7 * glm::length(directions.point(i));
                grid.set_value(static_cast<int>(s), i, {reach, 0});
            }
        }
        for (int round = 0; round < 40; ++round) grid.iterate(rifs);
        for (std::size_t s = 0; s < rifs.follow_sets.size(); ++s) {
            const int set = static_cast<int>(s);
            for (int i = 0; i < 300; ++i) {
                const glm::dvec3 point = systems::random_point(rifs, set, 120, random);
                const glm::dvec3 u = random_vector(random);
                ASSERT_LE(glm::dot(point, u), grid.support(set, u) + 1e-9) << "seed " << seed;
            }
        }
    }
}

}  // namespace
}  // namespace pxm::host
