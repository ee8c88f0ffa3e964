#include "host/fractal/bounds/polytope.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "host/fractal/bounds/support.hpp"
#include "tests/host/fractal/systems.hpp"

namespace pxm::host {
namespace {

Approximation known_of(const Rifs& rifs) {
    return approximation(rifs, bound(rifs, prove_contraction(rifs)));
}

bool contains(const Polytope& polytope, const glm::dvec3& point) {
    for (const HalfSpace& half_space : polytope) {
        if (glm::dot(half_space.normal, point) > half_space.offset) return false;
    }
    return true;
}

bool contains(const OrientedBox& box, const glm::dvec3& point) {
    for (const glm::dvec3& half : box.half) {
        const double size = glm::dot(half, half);
        if (std::abs(glm::dot(point - box.center, half)) > size * (1 + 1e-12)) return false;
    }
    return true;
}

TEST(Polytope, contains_the_attractor_and_is_small_enough) {
    std::mt19937_64 random(1);
    for (const auto& [name, rifs] : systems::thesis_systems()) {
        const Approximation known = known_of(rifs);
        const Polytope hull = polytope(rifs, known, rifs.start);
        const OrientedBox box = oriented_box(rifs, known, rifs.start);
        EXPECT_LE(hull.size(), 32u) << name;
        for (int i = 0; i < 200; ++i) {
            const glm::dvec3 point = systems::random_point(rifs, rifs.start, 700, random);
            ASSERT_TRUE(contains(hull, point)) << name;
            ASSERT_TRUE(contains(box, point)) << name;
        }
    }
}

TEST(Polytope, every_half_space_touches_the_attractor) {
    for (const auto& [name, rifs] : systems::thesis_systems()) {
        const Approximation known = known_of(rifs);
        const double size = known.outer[rifs.start].ball.radius;
        for (const HalfSpace& half_space : polytope(rifs, known, rifs.start)) {
            const Reach exact =
                reach(rifs, known, rifs.start, half_space.normal, 1e-6 * size, 1'000'000);
            EXPECT_LE(half_space.offset, exact.lower + 1e-4 * size) << name;
        }
    }
}

TEST(Polytope, has_the_faces_of_the_solid_where_there_is_one) {
    const auto faces = [](const Rifs& rifs) { return polytope(rifs, known_of(rifs), 0).size(); };
    EXPECT_EQ(faces(systems::tetra()), 4u);
    EXPECT_EQ(faces(systems::octo()), 8u);
    EXPECT_EQ(faces(systems::menger()), 6u);
    EXPECT_EQ(faces(systems::icos()), 20u);
}

TEST(Polytope, of_a_flat_attractor_is_flat) {
    const Rifs rifs =
        systems::complete(systems::homotheties(0.5, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    const Polytope hull = polytope(rifs, known_of(rifs), 0);
    EXPECT_FALSE(contains(hull, {0.5, 0.5, 1e-6}));
    EXPECT_FALSE(contains(hull, {0.5, 0.5, -1e-6}));
    EXPECT_TRUE(contains(hull, {0.5, 0.5, 0}));
}

TEST(OrientedBox, follows_a_system_that_is_turned) {
    const Affine turn = systems::map({rotation(Axis::x, 25), rotation(Axis::y, 70)});
    Rifs turned = systems::grass();
    for (Affine& affine : turned.maps) affine = then(then(inverse(turn), affine), turn);
    const auto volume = [](const OrientedBox& box) {
        return 8 * glm::length(box.half[0]) * glm::length(box.half[1]) * glm::length(box.half[2]);
    };
    const Rifs grass = systems::grass();
    EXPECT_LE(volume(oriented_box(turned, known_of(turned), 0)),
              1.25 * volume(oriented_box(grass, known_of(grass), 0)));
}

TEST(OrientedBox, support_is_the_reach_of_its_corners) {
    const OrientedBox box = oriented_box(rotation(Axis::z, 30).linear, {-1, -2, -3}, {4, 5, 6});
    std::mt19937_64 random(2);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 50; ++i) {
        const glm::dvec3 u{normal(random), normal(random), normal(random)};
        double reach = -1e300;
        for (int corner = 0; corner < 8; ++corner) {
            glm::dvec3 point = box.center;
            for (int k = 0; k < 3; ++k)
                point += box.half[k] * ((corner >> k & 1) != 0 ? 1.0 : -1.0);
            reach = std::max(reach, glm::dot(point, u));
        }
        EXPECT_NEAR(support(box, u), reach, 1e-12);
    }
}

}  // namespace
}  // namespace pxm::host
