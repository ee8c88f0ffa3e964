// What is printed as exact, at most, yes or no is so.
#include "tests/host/fractal/claims.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "host/fractal/dimension/exact_word.hpp"
#include "host/fractal/dimension/neighbours.hpp"
#include "host/fractal/dimension/similarity.hpp"
#include "host/fractal/system/elimination.hpp"
#include "host/text/six_digits.hpp"
#include "tests/host/fractal/systems.hpp"

namespace pxm::host {
namespace {

using systems::Claims;
using systems::claims_of;
using systems::complete;
using systems::map;
using systems::with_graph;

Rifs interval_in(const std::vector<double>& parts) {
    std::vector<Affine> maps;
    double place = 0;
    for (const double part : parts) {
        maps.push_back(map({scaling(glm::dvec3{part}), translation({place, 0, 0})}));
        place += part;
    }
    return complete(maps);
}

TEST(Claims, an_interval_in_parts_is_never_totally_disconnected) {
    EXPECT_EQ(claims_of(interval_in({0.3, 0.6, 0.1})).disconnected.totally_disconnected, false);
    for (int n = 2; n <= 13; ++n) {
        const Claims claims = claims_of(interval_in(std::vector<double>(n, 1.0 / n)));
        EXPECT_EQ(claims.disconnected.totally_disconnected, false) << n;
        EXPECT_NEAR(claims.dimensions.exact.value_or(0), 1, 1e-9) << n;
        EXPECT_GE(claims.dimensions.upper, 1) << n;
    }
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> weight(0.01, 1);
    for (int round = 0; round < 30; ++round) {
        std::vector<double> parts(2 + random() % 9);
        double sum = 0;
        for (double& part : parts) sum += part = weight(random);
        for (double& part : parts) part /= sum;
        EXPECT_NE(claims_of(interval_in(parts)).disconnected.totally_disconnected, true) << round;
    }
}

TEST(Claims, constants_that_add_up_to_less_than_1_still_decide) {
    EXPECT_EQ(claims_of(interval_in({0.3, 0.6, 0.1 - 1e-9})).disconnected.totally_disconnected,
              true);
}

/// diag(1/3, 1/2, z) three times, in a plane that `turn` leads to.
Rifs flat_carpet(double z, const Affine& turn) {
    std::vector<Affine> maps;
    for (const glm::dvec3& offset : {glm::dvec3{0, 0, 0}, {1.0 / 3, 0.5, 0}, {2.0 / 3, 0, 0}}) {
        const Affine m = map({scaling({1.0 / 3, 0.5, z}), translation(offset)});
        maps.push_back(then(then(inverse(turn), m), turn));
    }
    return complete(maps);
}

TEST(Claims, a_set_in_a_plane_has_no_thickness) {
    const double known = 1 + std::log(1.5) / std::log(3);
    for (const double z : {0.0, 0.01, 0.408, 0.7}) {
        const Claims claims = claims_of(flat_carpet(z, Affine{}));
        EXPECT_TRUE(claims.dimensions.affinity.exact) << z;
        EXPECT_NEAR(claims.dimensions.affinity.value, known, 1e-9) << z;
        EXPECT_EQ(claims.dimensions.hull, 2) << z;
    }
    const Affine turn = map({rotation(Axis::x, 30), rotation(Axis::y, 50), translation({1, 2, 3})});
    const Affinity turned = affinity_dimension(flat_carpet(0.7, turn));
    EXPECT_NEAR(turned.value, known, 0.02);
    EXPECT_GE(turned.upper, known - 1e-12);
    EXPECT_LT(turned.upper, 1.6);
}

TEST(Claims, a_flat_set_of_plane_similitudes_is_one_of_similitudes) {
    const Claims claims = claims_of(
        "ifs gasket { newmap scale: 1/2,1/2,0.9 newmap scale: 1/2,1/2,0 translate: 1/2,0,0"
        " newmap scale: 1/2,1/2,0.1 translate: 0,1/2,0 }");
    EXPECT_NEAR(claims.dimensions.exact.value_or(0), std::log(3) / std::log(2), 1e-9);
}

const char* const turning_tile =
    "ifs tile { newmap matrix: 1/3,-1/3,0, 1/3,2/3,0, 0,0,1/sqrt(3), 0,0,0"
    " newmap matrix: 1/3,-1/3,0, 1/3,2/3,0, 0,0,1/sqrt(3), 1,0,0"
    " newmap matrix: 1/3,-1/3,0, 1/3,2/3,0, 0,0,1/sqrt(3), 0,1,0 }";

TEST(Claims, similitudes_in_other_coordinates_are_exact) {
    const Claims tile = claims_of(turning_tile);
    EXPECT_TRUE(tile.dimensions.affinity.exact);
    EXPECT_NEAR(tile.dimensions.affinity.value, 2, 1e-9);
    EXPECT_EQ(tile.dimensions.upper, 2);
    // The words 1 3 and 3 2 are one map: (0,1) T = (1,0) T + (0,1).
    EXPECT_EQ(tile.open_set.condition, OpenSetCondition::fails);
    const Affine shear{{{1, 0.5, 0}, {0.3, 1, 0.2}, {0, 0.4, 1}}, {0, 0, 0}};
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int round = 0; round < 10; ++round) {
        std::vector<Affine> plain;
        std::vector<Affine> sheared;
        for (int m = 0; m < 4; ++m) {
            plain.push_back(
                map({rotation(Axis::x, 180 * unit(random)), rotation(Axis::z, 180 * unit(random)),
                     scaling(glm::dvec3{0.5 + 0.2 * unit(random)}),
                     translation({unit(random), unit(random), unit(random)})}));
            sheared.push_back(then(then(inverse(shear), plain.back()), shear));
        }
        const Affinity found = affinity_dimension(complete(sheared));
        EXPECT_TRUE(found.exact) << round;
        EXPECT_NEAR(found.value, affinity_dimension(complete(plain)).value, 1e-9) << round;
    }
}

TEST(Claims, a_set_in_a_plane_has_at_most_dimension_2_and_no_open_set_if_it_would_need_more) {
    const Claims claims = claims_of(
        "ifs p { newmap scale: 0.65 newmap scale: 0.65 translate: 0.35,0,0"
        " newmap scale: 0.65 translate: 0.17,0.3,0 }");
    EXPECT_EQ(claims.dimensions.upper, 2);
    EXPECT_EQ(claims.open_set.condition, OpenSetCondition::fails);
    const Claims line = claims_of(
        "ifs l { newmap scale: 0.61 rotate: x,20 newmap scale: 0.61 translate: 0.39,0,0 }");
    EXPECT_EQ(line.dimensions.upper, 1);
    EXPECT_EQ(line.open_set.condition, OpenSetCondition::fails);
}

Rifs ring(int maps) {
    std::vector<Affine> moves;
    std::vector<std::vector<int>> follow;
    for (int m = 0; m < maps; ++m) {
        moves.push_back(map({scaling(glm::dvec3{m == 0 ? 0.5 : 1}), translation({1, 0, 0})}));
        follow.push_back({(m + 1) % maps});
    }
    return with_graph(moves, follow);
}

TEST(Claims, what_never_branches_has_dimension_0) {
    for (const int maps : {1, 2, 10, 1000}) {
        const Rifs rifs = reachable_part(ring(maps));
        const Dimensions found = dimensions(rifs, OpenSetCondition::unknown);
        EXPECT_EQ(found.similarity.value().high, 0) << maps;
        EXPECT_EQ(found.affinity.upper, 0) << maps;
        EXPECT_EQ(found.exact, 0) << maps;
    }
}

TEST(Claims, a_long_ring_with_one_choice_is_as_exact_as_a_short_one) {
    Rifs rifs = ring(300);
    rifs.maps.push_back(map({scaling(glm::dvec3{0.5}), translation({2, 0, 0})}));
    rifs.map_names.push_back("other");
    rifs.follow_of.push_back(rifs.follow_of[0]);
    rifs.follow_sets[rifs.follow_of[299]].maps.push_back(300);  // 2 (1/2)^d = 1
    const Interval found = similarity_dimension(rifs).value();
    EXPECT_NEAR(found.middle(), 1, 1e-9);
    EXPECT_LT(found.error(), 1e-9);
}

TEST(Claims, disjoint_images_decide_the_open_set_condition) {
    const Claims claims = claims_of(
        "ifs nested { newmap scale: 1/2 newmap scale: 1/10 translate: 9/10,0,0"
        " newmap scale: 1/50 translate: 3/10,0,0 }");
    EXPECT_EQ(claims.open_set.condition, OpenSetCondition::holds);
    EXPECT_NEAR(claims.dimensions.exact.value_or(0), 0.60469, 1e-5);
}

TEST(Claims, maps_that_are_passed_once_do_not_matter_to_the_dimension) {
    const Claims claims = claims_of(
        "rifs copies { newmap a scale: 1,1,1 newmap b translate: 0.1,0,0 newmap c scale: 1/3"
        " newmap d scale: 1/3 translate: 2/3,0,0 follow: a -> c,d follow: b -> c,d"
        " follow: c -> c,d follow: d -> c,d start: a,b }");
    EXPECT_EQ(claims.open_set.condition, OpenSetCondition::holds);
    EXPECT_NEAR(claims.dimensions.exact.value_or(0), std::log(2) / std::log(3), 1e-9);
}

TEST(Claims, overlaps_of_three_letters_are_found_and_an_interval_is_known) {
    const Claims claims =
        claims_of("let r = 1/phi ifs g { newmap scale: r newmap scale: r translate: 1-r,0,0 }");
    EXPECT_EQ(claims.open_set.condition, OpenSetCondition::fails);
    // No double is 1/phi.
    EXPECT_THAT(claims.open_set.why,
                testing::MatchesRegex("the words 1 2 2 and 2 1 1 are the same map, up to "
                                      "[1-9]e-1[56] of the attractor's size"));
    EXPECT_EQ(claims.disconnected.totally_disconnected, false);
    EXPECT_EQ(claims.dimensions.exact, 1);
}

TEST(Claims, equal_numbers_alone_are_called_the_same_map) {
    EXPECT_EQ(claims_of("ifs a { newmap scale: 0.3 newmap scale: 0.3 translate: 0.7,0,0"
                        " newmap scale: 0.3 }")
                  .open_set.why,
              "map 1 and map 3 are the same map");
    EXPECT_EQ(claims_of("ifs a { newmap scale: 1/2 newmap scale: 1/2 translate: 1/4,0,0"
                        " newmap scale: 1/2 translate: 1/2,0,0 }")
                  .open_set.why,
              "the words 1 3 and 2 1 are the same map");
    // They are the same in the plane that the attractor lies in, and nowhere else.
    EXPECT_THAT(claims_of("ifs a { newmap scale: 1/2,1/2,0.9 newmap scale: 1/2,1/2,0"
                          " newmap scale: 1/2 translate: 1/2,0,0"
                          " newmap scale: 1/2 translate: 0,1/2,0 }")
                    .open_set.why,
                testing::StartsWith("map 1 and map 2 are the same map, up to 1e-16 of "));
}

TEST(Claims, maps_that_differ_by_more_than_rounding_are_not_the_same) {
    for (const double apart : {1e-10, 1e-11, 1e-12, 1e-13}) {
        const Claims claims = claims_of(
            complete(systems::homotheties(0.4, {{0, 0, 0}, {apart, 0, 0}, {0.6, 0.1, 0}})));
        EXPECT_EQ(claims.open_set.condition, OpenSetCondition::unknown) << apart;
    }
}

/// Map 1 and 2 have the same translation, and linear parts whose difference is nothing beside 1; to
/// an attractor that is far away it means a place of its own.
TEST(Claims, far_from_the_origin_linear_parts_are_places) {
    constexpr double far = 1e6;
    const auto toward = [](double ratio, const glm::dvec3& center) {
        return Affine{glm::dmat3{ratio}, center / 2.0};
    };
    const glm::dvec3 center{far, far, far};
    for (const double more : {0.0, 4e-11, 4e-10}) {
        const Claims claims = claims_of(complete({toward(0.5, center), toward(0.5 + more, center),
                                                  toward(0.5, center + glm::dvec3{1, 0, 0}),
                                                  toward(0.5, center + glm::dvec3{0, 1, 0})}));
        EXPECT_EQ(claims.open_set.condition == OpenSetCondition::fails, more == 0)
            << more << claims.open_set.why;
    }
}

TEST(ExactWord, is_a_word_whose_numbers_double_holds) {
    Rifs rifs = complete(systems::homotheties(0.5, {{0, 0, 0}, {0.25, 0, 0}, {0.5, 0, 0}}));
    EXPECT_EQ(exact_word(rifs, {1, 0}), then(rifs.maps[0], rifs.maps[1]));
    EXPECT_TRUE(are_exactly_one_map(rifs, {0, 2}, {1, 0}));
    EXPECT_FALSE(are_exactly_one_map(rifs, {0, 2}, {1, 2}));
    rifs.follow_of[0] = 1;
    EXPECT_FALSE(are_exactly_one_map(rifs, {0, 2}, {1, 0}));
    for (const double ratio : {0.1, 1.0 / 3, 0x1.0000001p-1, 0x1p-500}) {
        const Rifs rounded = complete(systems::homotheties(ratio, {{0, 0, 0}, {0, 1, 0}}));
        EXPECT_EQ(exact_word(rounded, {0}), rounded.maps[0]);
        EXPECT_FALSE(exact_word(rounded, {0, 0}) && ratio > 0x1p-400) << ratio;
        EXPECT_FALSE(exact_word(rounded, {0, 1, 1, 1}).has_value()) << ratio;
    }
}

TEST(Claims, curves_that_touch_themselves_meet_the_open_set_condition) {
    for (const char* text : {"ifs levy { newmap scale: 1/sqrt(2) rotate: z,45"
                             " newmap scale: 1/sqrt(2) rotate: z,-45 translate: 1/2,1/2,0 }",
                             "ifs heighway { newmap scale: 1/sqrt(2) rotate: z,45"
                             " newmap scale: 1/sqrt(2) rotate: z,135 translate: 1,0,0 }"}) {
        const Claims claims = claims_of(text);
        EXPECT_EQ(claims.open_set.condition, OpenSetCondition::holds) << text;
        EXPECT_NEAR(claims.dimensions.exact.value_or(0), 2, 1e-9) << text;
        EXPECT_EQ(claims.disconnected.totally_disconnected, false) << text;
    }
}

/// Whether two words of at most `length` digits in base 1/ratio have the same value: whole numbers.
bool have_equal_words(const std::vector<long>& digits, long base, int length) {
    std::set<long> sums{0};
    std::size_t words = 1;
    for (int n = 0; n < length; ++n) {
        std::set<long> longer;
        for (const long sum : sums) {
            for (const long digit : digits) longer.insert(sum * base + digit);
        }
        sums = std::move(longer);
        words *= digits.size();
    }
    return sums.size() < words;
}

TEST(Claims, the_open_set_condition_of_digits_is_that_no_two_words_are_equal) {
    std::mt19937_64 random(5);
    int fails = 0;
    for (int round = 0; round < 60; ++round) {
        const long base = 2 + static_cast<long>(random() % 3);
        std::set<long> digits{0};
        while (static_cast<long>(digits.size()) < base) digits.insert(long(random() % 12));
        std::vector<Affine> maps;
        for (const long digit : digits) {
            maps.push_back(map({scaling(glm::dvec3{1.0 / double(base)}),
                                translation({double(digit) / double(base), 0, 0})}));
        }
        const bool equal = have_equal_words({digits.begin(), digits.end()}, base, 6);
        const OpenSetCondition found = claims_of(complete(maps)).open_set.condition;
        EXPECT_EQ(found, equal ? OpenSetCondition::fails : OpenSetCondition::holds) << round;
        fails += equal;
    }
    EXPECT_GT(fails, 10);
    EXPECT_LT(fails, 50);
}

TEST(Claims, a_small_overlap_is_none_that_holds) {
    for (const double more : {1e-3, 1e-6, 1e-9, 1e-10}) {
        const double r = 0.5 + more;
        const OpenSetCondition found =
            claims_of(complete(systems::homotheties(r, {{0, 0, 0}, {1 - r, 0, 0}})))
                .open_set.condition;
        EXPECT_NE(found, OpenSetCondition::holds) << more;
    }
}

/// A matrix [[a, b], [c, d]] over two follow sets.
StepMatrix two_by_two(double a, double b, double c, double d) {
    StepMatrix matrix;
    matrix.add_row({0, 1}, {a, b});
    matrix.add_row({0, 1}, {c, d});
    return matrix;
}

TEST(Growth, is_never_wrong_near_1) {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> entry(0.01, 1);
    for (int round = 0; round < 2000; ++round) {
        long double e[4];
        for (long double& x : e) x = entry(random);
        const long double radius =
            (e[0] + e[3] + std::sqrt((e[0] - e[3]) * (e[0] - e[3]) + 4 * e[1] * e[2])) / 2;
        const double off = std::pow(10.0, -1 - static_cast<double>(random() % 16));
        const bool above = random() % 2 == 0;
        const long double scale = (above ? 1 + off : 1 - off) / radius;
        const StepMatrix matrix = two_by_two(double(e[0] * scale), double(e[1] * scale),
                                             double(e[2] * scale), double(e[3] * scale));
        for (const Growth found :
             {growth(matrix, {{0, 1}}), growth_by_elimination(matrix, {0, 1}, scene_error)}) {
            EXPECT_NE(found, above ? Growth::below_one : Growth::above_one) << round;
            EXPECT_TRUE(found != Growth::unclear || off < 1e-9) << round;
        }
    }
}

TEST(SixDigits, are_never_below_the_number) {
    std::mt19937_64 random(13);
    std::uniform_real_distribution<double> digit(0.1, 10);
    for (int round = 0; round < 1000; ++round) {
        const double x = digit(random) * std::pow(10, static_cast<double>(random() % 7) - 3);
        const double printed = std::stod(six_digits_above(x));
        EXPECT_GE(printed, x * (1 - 1e-12));
        EXPECT_LE(printed, x * (1 + 1.1e-5));
    }
    EXPECT_EQ(six_digits_above(2), "2");
    EXPECT_EQ(six_digits_above(2.0805530), "2.08056");
}

}  // namespace
}  // namespace pxm::host
