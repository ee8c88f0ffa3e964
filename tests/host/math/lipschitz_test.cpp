#include "host/math/lipschitz.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "tests/host/fractal/systems.hpp"

namespace pxm::host {
namespace {

using systems::map;

TEST(Lipschitz, singular_values_rebuild_the_map) {
    std::mt19937_64 random(11);
    for (int i = 0; i < 100; ++i) {
        const Affine affine = systems::random_map(random, 2);
        const SingularValues singular = singular_values(affine.linear);
        EXPECT_GE(singular.values[0], singular.values[1]);
        EXPECT_GE(singular.values[1], singular.values[2]);
        for (int k = 0; k < 3; ++k) {
            const glm::dvec3 image = affine.direction(singular.input[k]);
            EXPECT_LT(glm::distance(image, singular.values[k] * singular.output[k]), 1e-14);
            EXPECT_NEAR(glm::length(singular.output[k]), 1, 1e-14);
        }
    }
}

// Erratum 6: the product of constants (Eq. 16.1) is an upper, the determinant (Eq. 16.3) a lower
// bound.
TEST(Lipschitz, determinant_is_below_polar_is_below_product_on_random_words) {
    std::mt19937_64 random(7);
    for (int i = 0; i < 200; ++i) {
        Affine word;
        double product = 1;
        for (int length = 0; length < 6; ++length) {
            const Affine next = systems::random_map(random, 0.9);
            word = then(next, word);
            product *= lipschitz_constant(next);
            EXPECT_LE(determinant_constant(word), lipschitz_constant(word) * (1 + 1e-12));
            EXPECT_LE(lipschitz_constant(word), product * (1 + 1e-12));
        }
    }
}

TEST(Lipschitz, no_vector_is_stretched_more_and_one_is_stretched_as_much) {
    std::mt19937_64 random(3);
    for (int i = 0; i < 50; ++i) {
        const Affine affine = systems::random_map(random, 1.5);
        const double lip = lipschitz_constant(affine);
        double stretched = 0;
        for (int k = 0; k < 2000; ++k) {
            const glm::dvec3 u =
                glm::normalize(systems::random_map(random, 1).translation + glm::dvec3{1e-9});
            stretched = std::max(stretched, glm::length(affine.direction(u)));
        }
        EXPECT_LE(stretched, lip * (1 + 1e-14));
        EXPECT_GE(stretched, lip * 0.95);
    }
}

TEST(Lipschitz, a_reflection_has_the_constants_of_its_size) {
    const Affine mirrored = scaling({-0.5, 0.5, 0.5});
    EXPECT_DOUBLE_EQ(lipschitz_constant(mirrored), 0.5);
    EXPECT_DOUBLE_EQ(determinant_constant(mirrored), 0.5);
}

TEST(Lipschitz, maps_are_told_apart_by_their_singular_values) {
    EXPECT_EQ(classify(map({scaling(glm::dvec3{0.3}), translation({1, 2, 3})})),
              MapKind::homothety);
    EXPECT_EQ(classify(map({scaling(glm::dvec3{0.3}), rotation(Axis::x, 30)})),
              MapKind::similitude);
    EXPECT_EQ(classify(scaling({0.3, -0.3, 0.3})), MapKind::similitude);
    EXPECT_EQ(classify(scaling(glm::dvec3{-0.3})), MapKind::similitude);
    EXPECT_EQ(classify(scaling({0.3, 0.3, 0.300001})), MapKind::affine);
    EXPECT_EQ(classify(scaling({0.3, 0.3, 1e-13})), MapKind::singular);
    EXPECT_EQ(classify(scaling(glm::dvec3{0.0})), MapKind::singular);
}

TEST(Lipschitz, lifting_raises_vanishing_values_only) {
    const Affine stem = map({rotation(Axis::x, 20), scaling({0, 0.16, 0}), rotation(Axis::z, 33)});
    const Affine lifted = lift(stem, 1e-4);
    const SingularValues singular = singular_values(lifted.linear);
    EXPECT_NEAR(singular.values[0], 0.16, 1e-15);
    EXPECT_NEAR(singular.values[1], 1e-4, 1e-15);
    EXPECT_NEAR(singular.values[2], 1e-4, 1e-15);
    EXPECT_EQ(lifted.translation, stem.translation);
}

TEST(Lipschitz, the_zero_map_is_lifted_to_a_ball) {
    const Affine lifted = lift(scaling(glm::dvec3{0.0}), 0.01);
    for (const double value : singular_values(lifted.linear).values)
        EXPECT_NEAR(value, 0.01, 1e-15);
}

TEST(Lipschitz, lifting_leaves_a_regular_map_as_it_is) {
    const Affine squashed = map({scaling({0.25, 0.01, 0.01}), rotation(Axis::z, 90)});
    EXPECT_EQ(lift(squashed, 0.5), squashed);
}

TEST(Lipschitz, what_is_not_finite_may_stretch_without_bound_and_squash_to_nothing) {
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
        Affine affine;
        affine.linear[1][2] = bad;
        EXPECT_EQ(lipschitz_constant(affine), std::numeric_limits<double>::infinity());
        EXPECT_EQ(smallest_singular_value(affine), 0);
        EXPECT_EQ(classify(affine), MapKind::singular);
    }
}

TEST(Lipschitz, lifting_never_makes_a_map_thinner) {
    Affine shear = scaling(glm::dvec3{0.5});
    shear.linear[0][2] = 1e12;
    const double before = smallest_singular_value(shear);
    EXPECT_GE(smallest_singular_value(lift(shear, before / 100)), before * (1 - 1e-3));
}

}  // namespace
}  // namespace pxm::host
