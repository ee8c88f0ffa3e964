#include "host/fractal/bounds/support.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "host/fractal/bounds/farthest.hpp"
#include "tests/host/fractal/systems.hpp"

namespace pxm::host {
namespace {

std::vector<Bounds> bound_of(const Rifs& rifs) { return bound(rifs, prove_contraction(rifs)); }

glm::dvec3 random_direction(std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    return glm::normalize(glm::dvec3{normal(random), normal(random), normal(random)});
}

TEST(Support, of_equal_homotheties_is_that_of_their_fixed_points) {
    std::mt19937_64 random(1);
    const Rifs rifs = systems::octo();
    const auto bounds = bound_of(rifs);
    for (int i = 0; i < 50; ++i) {
        const glm::dvec3 u = random_direction(random);
        const double corner = std::max({std::abs(u.x), std::abs(u.y), std::abs(u.z)});
        EXPECT_NEAR(support(rifs, bounds, 0, u, 1e-9), corner, 2e-9);
    }
}

// h_s(u) = max over m in s of h_t(u T_m^T) + u . a_m.
TEST(Support, obeys_its_own_equation) {
    std::mt19937_64 random(2);
    for (const Rifs& rifs : {systems::elm(), systems::pine(), systems::pound_sign()}) {
        const auto bounds = bound_of(rifs);
        for (int i = 0; i < 5; ++i) {
            const glm::dvec3 u = random_direction(random);
            double images = -1e300;
            for (const int m : rifs.follow_sets[rifs.start].maps) {
                const Affine& map = rifs.maps[m];
                images = std::max(
                    images, glm::dot(u, map.translation) +
                                support(rifs, bounds, rifs.follow_of[m], u * map.linear, 1e-6));
            }
            EXPECT_NEAR(support(rifs, bounds, rifs.start, u, 1e-6), images, 2e-6);
        }
    }
}

TEST(Support, a_face_of_menger_costs_few_cells) {
    const Rifs rifs = systems::menger(1.0 / 3, 2.0 / 3);
    const Approximation known = approximation(rifs, bound_of(rifs));
    const Reach found = reach(rifs, known, 0, {1, 0, 0}, 1e-12, 1'000'000);
    EXPECT_NEAR(found.upper, 1, 1e-9);
    EXPECT_LT(found.cells, 2'000);
}

TEST(Support, the_point_found_has_the_lower_reach) {
    std::mt19937_64 random(3);
    const Rifs rifs = systems::elm();
    const Approximation known = approximation(rifs, bound_of(rifs));
    for (int i = 0; i < 20; ++i) {
        const glm::dvec3 u = random_direction(random);
        const Reach found = reach(rifs, known, 0, u, 1e-7, 1'000'000);
        EXPECT_NEAR(glm::dot(found.point, u), found.lower, 1e-12);
        EXPECT_LE(found.lower, found.upper);
        EXPECT_LE(found.upper - found.lower, 1e-7);
    }
}

TEST(Support, a_spent_budget_leaves_the_bound_above) {
    std::mt19937_64 random(4);
    const Rifs rifs = systems::elm();
    const Approximation known = approximation(rifs, bound_of(rifs));
    for (int i = 0; i < 20; ++i) {
        const glm::dvec3 u = random_direction(random);
        const double exact = reach(rifs, known, 0, u, 1e-9, 1'000'000).upper;
        for (const long budget : {1L, 20L, 60L}) {
            EXPECT_GE(reach(rifs, known, 0, u, 1e-9, budget).upper, exact - 1e-9);
        }
    }
}

TEST(Farthest, finds_the_corner_of_the_tetra) {
    const Rifs rifs = systems::tetra();
    const Approximation known = approximation(rifs, bound_of(rifs));
    const glm::dvec3 from{0, -5, 0};
    const Reach found = farthest(rifs, known, 0, from, {0, 1e-9, 0, 1'000'000});
    EXPECT_NEAR(found.upper, 6, 1e-8);  // the apex, twice (0, 0.5, 0)
    EXPECT_NEAR(glm::distance(found.point, from), found.lower, 1e-12);
}

TEST(Farthest, no_point_lies_beyond_the_upper_bound_whatever_the_budget) {
    std::mt19937_64 random(5);
    for (unsigned seed = 0; seed < 20; ++seed) {
        const Rifs rifs = systems::random_system(seed, 0.7);
        const Approximation known = approximation(rifs, bound_of(rifs));
        const glm::dvec3 from = random_direction(random);
        for (const long budget : {1L, 50L, 2'000L}) {
            const Reach found = farthest(rifs, known, 0, from, {0, 1e-4, 0, budget});
            for (int i = 0; i < 50; ++i) {
                const glm::dvec3 point = systems::random_point(rifs, 0, 90, random);
                ASSERT_LE(glm::distance(point, from), found.upper + 1e-9) << "seed " << seed;
            }
        }
    }
}

}  // namespace
}  // namespace pxm::host
