// Where cells meet in threes, and into how many parts what is not connected falls.
#include <gtest/gtest.h>

#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/host/fractal/neighbours/findings_of.hpp"

namespace pxm::test {
namespace {

using host::ExactFindings;

std::string square_of(int n, const std::set<std::pair<int, int>>& places) {
    std::vector<std::string> maps;
    const std::string by = "/" + std::to_string(n);
    for (const auto& [x, y] : places)
        maps.push_back("scale: 1" + by + " translate: " + std::to_string(x) + by + "," +
                       std::to_string(y) + by + ",0");
    return system_of(maps);
}

/// Of the lattice {-1, 0, 1}^n: pairs of neighbours of a box that are neighbours of each other.
std::size_t box_triples(int dimensions) {
    std::size_t ordered = 1, ways = 7, touching = 3;  // of 9 pairs of steps of -1, 0 and 1
    std::size_t with_a_zero = 1;
    for (int i = 0; i < dimensions; ++i) {
        ordered *= ways;
        with_a_zero *= touching;
    }
    return (ordered - (3 * with_a_zero - 2)) / 2;
}

TEST(Meeting, boxes_meet_in_threes_as_the_lattice_says) {
    const ExactFindings square = exact_of(square_of(2, {{0, 0}, {0, 1}, {1, 0}, {1, 1}}));
    EXPECT_EQ(square.triples.value, box_triples(2)) << square.triples.why;
    EXPECT_EQ(square.triples.value, 12U);
    EXPECT_NEAR(square.triple_dimension.value.value(), 0, 1e-9);  // corners
    std::vector<std::string> maps;
    for (int i = 0; i < 8; ++i)
        maps.push_back("scale: 1/2 translate: " + std::to_string(i % 2) + "/2," +
                       std::to_string(i / 2 % 2) + "/2," + std::to_string(i / 4) + "/2");
    const ExactFindings cube = exact_of(system_of(maps));
    EXPECT_EQ(cube.triples.value, box_triples(3)) << cube.triples.why;
    EXPECT_EQ(cube.triples.value, 132U);
    EXPECT_NEAR(cube.triple_dimension.value.value(), 1, 1e-9);  // edges
}

/// Tiles that lie like hexagons: six points of each belong to two others [AT04].
TEST(Meeting, tiles_with_six_neighbours_meet_in_threes_at_six_points) {
    const ExactFindings dragon = exact_of(system_of(
        {"scale: 1/sqrt(2) rotate: z,45", "scale: 1/sqrt(2) rotate: z,45 translate: 1/2,1/2,0"}));
    EXPECT_EQ(dragon.touching, 6U);
    EXPECT_EQ(dragon.triples.value, 6U) << dragon.triples.why;
    EXPECT_NEAR(dragon.triple_dimension.value.value(), 0, 1e-9);
}

/// A corner of the gasket, the tetrahedron or the pentagon's gasket is one of two cells, no more.
TEST(Meeting, gaskets_meet_in_twos) {
    for (const std::vector<std::string>& maps : std::vector<std::vector<std::string>>{
             {"scale: 1/2", "scale: 1/2 translate: 1/2,0,0",
              "scale: 1/2 translate: 1/4,sqrt(3)/4,0"},
             {"scale: 1/2", "scale: 1/2 translate: 1/2,0,0",
              "scale: 1/2 translate: 1/4,sqrt(3)/4,0",
              "scale: 1/2 translate: 1/4,sqrt(3)/12,sqrt(6)/6"}}) {
        const ExactFindings found = exact_of(system_of(maps));
        EXPECT_GT(found.touching, 0U);
        EXPECT_EQ(found.triples.value, 0U) << found.triples.why;
        EXPECT_FALSE(found.triple_dimension.value);
    }
}

/// A triangle of four halves: its neighbours at a corner are six around a point.
TEST(Meeting, triangles_meet_at_corners) {
    const ExactFindings found = exact_of(system_of(
        {"scale: 1/2", "scale: 1/2 translate: 1/2,0,0", "scale: 1/2 translate: 1/4,sqrt(3)/4,0",
         "scale: 1/2 rotate: z,180 translate: 3/4,sqrt(3)/4,0"}));
    // Twelve neighbours; at each of three corners every two of the five others.
    EXPECT_EQ(found.touching % 12, 0U);
    EXPECT_EQ(found.triples.value, found.touching / 12 * 30) << found.touching;
    EXPECT_NEAR(found.triple_dimension.value.value(), 0, 1e-9);
}

/// Cells of different sizes, in a line: no point is in three intervals that do not overlap.
TEST(Meeting, intervals_meet_in_twos) {
    const ExactFindings found = exact_of(system_of(
        {"scale: 1/2", "scale: 1/4 translate: 1/2,0,0", "scale: 1/4 translate: 3/4,0,0"}));
    EXPECT_EQ(found.open_set.value, true);
    EXPECT_EQ(found.triples.value, 0U) << found.triples.why;
}

/// Squares of a half and a quarter: no more pairs than eight quarters around a point allow, and no
/// fewer than where three of them meet.
TEST(Meeting, squares_of_two_sizes_meet_at_corners) {
    std::vector<std::string> maps;
    for (const char* place : {"0,0", "1/2,0", "0,1/2"})
        maps.push_back(std::string("scale: 1/2 translate: ") + place + ",0");
    for (const char* place : {"1/2,1/2", "3/4,1/2", "1/2,3/4", "3/4,3/4"})
        maps.push_back(std::string("scale: 1/4 translate: ") + place + ",0");
    const ExactFindings found = exact_of(system_of(maps));
    ASSERT_TRUE(found.triples.value) << found.triples.why;
    EXPECT_GT(*found.triples.value, 12U);
    EXPECT_NEAR(found.triple_dimension.value.value(), 0, 1e-9);
    EXPECT_NEAR(found.volume.value.value(), 1, 1e-9) << found.volume.why;
}

TEST(Meeting, a_connected_set_has_no_parts) {
    EXPECT_TRUE(exact_of(square_of(2, {{0, 0}, {0, 1}, {1, 0}, {1, 1}})).parts_of_levels.empty());
}

TEST(Meeting, a_cantor_set_doubles_its_parts) {
    const ExactFindings found =
        exact_of(system_of({"scale: 1/3", "scale: 1/3 translate: 2/3,0,0"}));
    ASSERT_GT(found.parts_of_levels.size(), 5U);
    for (std::size_t level = 0; level < found.parts_of_levels.size(); ++level)
        EXPECT_EQ(found.parts_of_levels[level], std::size_t{2} << level);
    EXPECT_EQ(found.totally_disconnected.value, true);
}

/// Cells of level n as squares of whole numbers: those that share a side or a corner hang together,
/// where every cell has all four corners of its square.
std::size_t parts_by_counting(const std::set<std::pair<int, int>>& places, int n, int level) {
    std::set<std::pair<int, int>> cells{{0, 0}};
    for (int i = 0; i < level; ++i) {
        std::set<std::pair<int, int>> next;
        for (const auto& [x, y] : cells)
            for (const auto& [a, b] : places) next.insert({x * n + a, y * n + b});
        cells = next;
    }
    std::size_t parts = 0;
    while (!cells.empty()) {
        ++parts;
        std::vector<std::pair<int, int>> waiting{*cells.begin()};
        cells.erase(cells.begin());
        while (!waiting.empty()) {
            const auto [x, y] = waiting.back();
            waiting.pop_back();
            for (int dx = -1; dx <= 1; ++dx)
                for (int dy = -1; dy <= 1; ++dy)
                    if (cells.erase({x + dx, y + dy}) > 0) waiting.emplace_back(x + dx, y + dy);
        }
    }
    return parts;
}

/// The outermost columns and the corners between: two lines at each level, four, eight ...
TEST(Meeting, lines_over_a_cantor_set_are_neither_connected_nor_dust) {
    const std::set<std::pair<int, int>> places{{0, 0}, {0, 1}, {0, 2}, {2, 0}, {2, 1}, {2, 2}};
    const ExactFindings found = exact_of(square_of(3, places));
    EXPECT_EQ(found.connected.value, false);
    EXPECT_EQ(found.totally_disconnected.value, false) << found.totally_disconnected.why;
    ASSERT_GE(found.parts_of_levels.size(), 3U);
    for (std::size_t level = 0; level < found.parts_of_levels.size(); ++level)
        EXPECT_EQ(found.parts_of_levels[level], std::size_t{2} << level);
}

TEST(Meeting, parts_of_squares_are_those_that_whole_numbers_count) {
    const std::set<std::pair<int, int>> corners{{0, 0}, {4, 0}, {0, 4}, {4, 4}};
    for (const auto& more :
         std::vector<std::set<std::pair<int, int>>>{{{1, 0}, {3, 4}},
                                                    {{2, 2}},
                                                    {{1, 1}, {3, 3}},
                                                    {{1, 0}, {2, 0}, {3, 0}, {2, 4}},
                                                    {{1, 1}, {2, 2}, {1, 3}}}) {
        std::set<std::pair<int, int>> places = corners;
        places.insert(more.begin(), more.end());
        const ExactFindings found = exact_of(square_of(5, places));
        if (found.connected.value.value_or(false)) continue;
        ASSERT_GE(found.parts_of_levels.size(), 3U);
        for (int level = 1; level <= 3; ++level)
            EXPECT_EQ(found.parts_of_levels[static_cast<std::size_t>(level - 1)],
                      parts_by_counting(places, 5, level))
                << level << square_of(5, places);
    }
}

}  // namespace
}  // namespace pxm::test
