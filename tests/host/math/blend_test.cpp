// Laws of maps between two maps.
#include "host/math/blend.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <random>

#include "host/math/lipschitz.hpp"

namespace pxm::host {
namespace {

Affine blended(const Affine& a, const Affine& b, double share) {
    const auto map = blend(a, b, share);
    if (const auto* why = std::get_if<std::string>(&map)) {
        ADD_FAILURE() << *why;
        return {};
    }
    return std::get<Affine>(map);
}

std::string refusal(const Affine& a, const Affine& b) {
    const auto map = blend(a, b, 0.5);
    const auto* why = std::get_if<std::string>(&map);
    return why ? *why : "";
}

double distance(const Affine& a, const Affine& b) {
    double sum = glm::length(a.translation - b.translation);
    for (int i = 0; i < 3; ++i) sum += glm::length(a.linear[i] - b.linear[i]);
    return sum;
}

class Maps {
  public:
    explicit Maps(unsigned seed) : random_(seed) {}
    double number(double low, double high) {
        return std::uniform_real_distribution(low, high)(random_);
    }
    Affine similarity() {
        Affine map = scaling(glm::dvec3{number(0.2, 0.9)});
        for (const Axis axis : {Axis::x, Axis::y, Axis::z})
            map = then(map, rotation(axis, number(-80, 80)));
        return then(map, translation({number(-1, 1), number(-1, 1), number(-1, 1)}));
    }
    Affine affine() {
        return then(scaling({number(0.05, 0.9), number(0.05, 0.9), number(0.05, 0.9)}),
                    similarity());
    }

  private:
    std::mt19937 random_;
};

TEST(Blend, begins_and_ends_with_the_maps_themselves) {
    Maps maps(1);
    for (int i = 0; i < 100; ++i) {
        const Affine a = maps.affine(), b = maps.affine();
        EXPECT_EQ(blended(a, b, 0), a);
        EXPECT_EQ(blended(a, b, 1), b);
        EXPECT_LT(distance(blended(a, b, 1e-9), a), 1e-7);
        EXPECT_LT(distance(blended(a, b, 1 - 1e-9), b), 1e-7);
    }
}

TEST(Blend, is_the_same_way_back) {
    Maps maps(2);
    for (int i = 0; i < 100; ++i) {
        const Affine a = maps.affine(), b = maps.affine();
        const double share = maps.number(0, 1);
        EXPECT_LT(distance(blended(a, b, share), blended(b, a, 1 - share)), 1e-12);
    }
}

TEST(Blend, turns_at_constant_speed_the_short_way) {
    for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
        for (const double degrees : {30.0, 90.0, 179.0, -120.0}) {
            const Affine half = blended({}, rotation(axis, degrees), 0.5);
            EXPECT_LT(distance(half, rotation(axis, degrees / 2)), 1e-12) << degrees;
            const Affine third = blended({}, rotation(axis, degrees), 1.0 / 3);
            EXPECT_LT(distance(third, rotation(axis, degrees / 3)), 1e-12) << degrees;
        }
        // 270 degrees are 90 the other way.
        EXPECT_LT(distance(blended({}, rotation(axis, 270), 0.5), rotation(axis, -45)), 1e-12);
    }
}

TEST(Blend, sizes_go_by_their_logarithm) {
    const Affine map = blended(scaling({0.1, 1, 4}), scaling({0.9, 1, 1}), 0.5);
    EXPECT_LT(distance(map, scaling({0.3, 1, 2})), 1e-12);
}

TEST(Blend, of_similarities_is_one_and_no_map_on_the_way_is_flat) {
    Maps maps(3);
    for (int i = 0; i < 200; ++i) {
        const double share = maps.number(0, 1);
        const auto kind = classify(blended(maps.similarity(), maps.similarity(), share));
        EXPECT_TRUE(kind == MapKind::similitude || kind == MapKind::homothety);
        const Affine a = maps.affine(), b = maps.affine();
        const double volume = std::pow(determinant(a), 1 - share) * std::pow(determinant(b), share);
        EXPECT_NEAR(determinant(blended(a, b, share)) / volume, 1, 1e-9);
    }
}

TEST(Blend, of_two_that_mirror_mirrors) {
    const Affine a = scaling({-0.5, 0.5, 0.5});
    const Affine b = then(a, rotation(Axis::y, 60));
    EXPECT_LT(distance(blended(a, b, 0.5), then(a, rotation(Axis::y, 30))), 1e-12);
}

TEST(Blend, is_refused_where_there_is_no_way) {
    const Affine half = scaling(glm::dvec3{0.5});
    EXPECT_NE(refusal(half, scaling({0.5, 0.5, 0})).find("squashes flat"), std::string::npos);
    EXPECT_NE(refusal(half, scaling({-0.5, 0.5, 0.5})).find("mirrors"), std::string::npos);
    EXPECT_NE(refusal(half, rotation(Axis::z, 180)).find("half a turn"), std::string::npos);
    EXPECT_EQ(refusal(half, rotation(Axis::z, 179.9)), "");
}

}  // namespace
}  // namespace pxm::host
