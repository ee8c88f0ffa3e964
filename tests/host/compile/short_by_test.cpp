// Laws of host/compile/short_by: what sticks out of declared volumes.
#include "host/compile/short_by.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/host/fractal/systems.hpp"

namespace pxm::host {
namespace {

using systems::complete;
using systems::map;

std::vector<Bounds> bound_of(const Rifs& rifs) { return bound(rifs, prove_contraction(rifs)); }

double short_by(const Rifs& rifs, const DeclaredVolume& volume) {
    return short_by(rifs, bound_of(rifs), 0, volume);
}

/// The cube [low, high]^2 with y in [bottom, top], by halving it.
Rifs brick(double low, double high, double bottom, double top) {
    std::vector<Affine> maps;
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 corner{i & 1 ? high : low, i & 2 ? top : bottom, i & 4 ? high : low};
        maps.push_back(map({scaling(glm::dvec3{0.5}), translation(corner / 2.0)}));
    }
    return complete(maps);
}

TEST(ShortBy, a_sphere_that_contains_the_attractor_is_not_short) {
    const Rifs rifs = systems::grass();
    EXPECT_LE(short_by(rifs, bound_of(rifs), 0, SphereVolume{{0, 0, 0}, 3}), 0);
}

TEST(ShortBy, a_sphere_is_short_by_the_farthest_point) {
    const Rifs rifs = complete(systems::homotheties(0.5, {{0, 0, 0}, {1, 0, 0}}));  // [0,2] on x
    EXPECT_NEAR(short_by(rifs, bound_of(rifs), 0, SphereVolume{{0, 0, 0}, 1.5}), 0.5, 1e-3);
    EXPECT_GE(short_by(rifs, bound_of(rifs), 0, SphereVolume{{0, 0, 0}, 1.5}), 0.5);
}

TEST(ShortBy, a_volume_that_touches_is_not_short) {
    const Rifs rifs = systems::menger(1.0 / 3, 2.0 / 3);  // corners at +-1
    const auto bounds = bound_of(rifs);
    EXPECT_LE(short_by(rifs, bounds, 0, BoxVolume{glm::dvec3{-1}, glm::dvec3{1}}), 0);
    EXPECT_LE(short_by(rifs, bounds, 0, SphereVolume{{0, 0, 0}, std::sqrt(3.0)}), 0);
}

TEST(ShortBy, a_box_is_short_by_its_worst_side) {
    const Rifs rifs = systems::menger(1.0 / 3, 2.0 / 3);
    const BoxVolume box{{-1, -0.75, -1}, {1, 1, 0.5}};
    EXPECT_NEAR(short_by(rifs, bound_of(rifs), 0, box), 0.5, 1e-6);
}

/// Edges upright on the mantle: the reach along them is a tie of many cells.
TEST(ShortBy, a_cylinder_that_a_brick_touches_is_not_short) {
    const double side = std::sqrt(0.5);
    EXPECT_LE(short_by(brick(-side, side, -1, 1), CylinderVolume{}), 0);
}

TEST(ShortBy, a_cylinder_is_short_by_its_mantle_or_by_an_end) {
    EXPECT_NEAR(short_by(brick(-0.9, 0.8, -0.5, 0.5), CylinderVolume{}), 0.9 * std::sqrt(2.0) - 1,
                2e-3);
    EXPECT_NEAR(short_by(brick(-0.5, 0.5, -0.5, 1.25), CylinderVolume{}), 0.25, 1e-6);
    EXPECT_NEAR(short_by(brick(-0.5, 0.5, -1.5, 1), CylinderVolume{}), 0.5, 1e-6);
}

TEST(ShortBy, a_cone_that_a_brick_touches_is_not_short) {
    const double side = std::sqrt(0.5) / 2;  // corners at 1/2 from the axis
    EXPECT_LE(short_by(brick(-side, side, 0, 0.5), ConeVolume{}), 0);
}

TEST(ShortBy, a_cone_is_short_by_its_mantle_or_by_its_base) {
    const double out = 0.6 * std::sqrt(2.0) + 0.75 - 1;  // of the corner, along the slope
    EXPECT_NEAR(short_by(brick(-0.5, 0.6, 0, 0.75), ConeVolume{}), out / std::sqrt(2.0), 1e-3);
    EXPECT_GE(short_by(brick(-0.5, 0.6, 0, 0.75), ConeVolume{}), out / std::sqrt(2.0) - 1e-12);
    EXPECT_NEAR(short_by(brick(-0.2, 0.2, -0.25, 0.2), ConeVolume{}), 0.25, 1e-6);
}

TEST(ShortBy, a_volume_that_is_computed_never_is) {
    EXPECT_LE(short_by(systems::tetra(), AutoVolume{}), 0);
    EXPECT_LE(short_by(systems::tetra(), HullVolume{}), 0);
}

}  // namespace
}  // namespace pxm::host
