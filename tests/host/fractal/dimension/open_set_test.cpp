// The open-set condition and disconnectedness, where textbooks know the answer (Sec. 3.6, 3.7).
#include "host/fractal/dimension/open_set.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "host/fractal/dimension/disconnected.hpp"
#include "tests/host/fractal/systems.hpp"

namespace pxm::host {
namespace {

using systems::complete;
using systems::homotheties;
using systems::map;

OpenSetCondition open_set(const Rifs& rifs) {
    return decide_open_set(rifs, bound(rifs, prove_contraction(rifs))).condition;
}

std::optional<bool> disconnected(const Rifs& rifs, double affinity_upper = 3) {
    const auto bounds = bound(rifs, prove_contraction(rifs));
    return decide_disconnected(rifs, bounds, affinity_upper).totally_disconnected;
}

Rifs cantor(double ratio) { return complete(homotheties(ratio, {{0, 0, 0}, {1 - ratio, 0, 0}})); }

Rifs koch() {
    const auto part = [](double turn, double x, double y) {
        return map({scaling(glm::dvec3{1.0 / 3}), rotation(Axis::z, turn), translation({x, y, 0})});
    };
    return complete({part(0, 0, 0), part(60, 1.0 / 3, 0), part(-60, 0.5, std::sqrt(3) / 6),
                     part(0, 2.0 / 3, 0)});
}

TEST(OpenSet, holds_where_a_convex_set_shows_it) {
    for (const auto& [name, rifs] :
         std::vector<systems::NamedSystem>{{"tetra", systems::tetra()},
                                           {"octo", systems::octo()},
                                           {"Menger", systems::menger(1.0 / 3, 2.0 / 3)},
                                           {"pound sign", systems::pound_sign()},
                                           {"Cantor", cantor(1.0 / 3)},
                                           {"an interval", cantor(0.5)},
                                           {"Koch", koch()}}) {
        EXPECT_EQ(open_set(rifs), OpenSetCondition::holds) << name;
    }
}

TEST(OpenSet, fails_for_maps_that_coincide_or_take_more_volume_than_there_is) {
    EXPECT_EQ(open_set(complete({scaling(glm::dvec3{0.5}), scaling(glm::dvec3{0.5}),
                                 map({scaling(glm::dvec3{0.5}), translation({1, 0, 0})})})),
              OpenSetCondition::fails);
    EXPECT_EQ(open_set(systems::icos()), OpenSetCondition::fails);  // 12/8 of the volume
    // Halves at 0, 1/4 and 1/2: the words 1 3 and 2 1 are x/4 + 1/4.
    EXPECT_EQ(open_set(complete(homotheties(0.5, {{0, 0, 0}, {0.25, 0, 0}, {0.5, 0, 0}}))),
              OpenSetCondition::fails);
}

TEST(OpenSet, overlapping_maps_are_never_said_to_hold) {
    for (unsigned seed = 0; seed < 30; ++seed) {
        std::mt19937_64 random(seed);
        std::uniform_real_distribution<double> unit(0.51, 0.9);
        EXPECT_NE(open_set(cantor(unit(random))), OpenSetCondition::holds) << "seed " << seed;
    }
}

TEST(Disconnected, theorems_3_8_and_3_9_decide) {
    EXPECT_EQ(disconnected(cantor(0.3)), true);  // Theorem 3.9
    EXPECT_EQ(disconnected(complete(homotheties(0.45, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}))), true);
    EXPECT_EQ(disconnected(systems::menger()), true);  // Theorem 3.8: gaps, Erratum 12
}

TEST(Disconnected, linked_images_make_a_connected_attractor) {
    for (const Rifs& rifs : {systems::tetra(), systems::octo(), koch(), cantor(0.5),
                             systems::menger(1.0 / 3, 2.0 / 3)}) {
        EXPECT_EQ(disconnected(rifs), false);
    }
}

TEST(Disconnected, a_singular_map_keeps_theorem_3_8_from_deciding) {  // Erratum 16
    const Rifs rifs = complete(
        {map({scaling({0.6, 0.6, 0.6})}), map({scaling({0.6, 0, 0.6}), translation({1, 5, 0})})});
    EXPECT_NE(disconnected(rifs), true);
}

}  // namespace
}  // namespace pxm::host
