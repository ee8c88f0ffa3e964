// How many connected pieces an attractor has, where the numbers of parts at its levels tell it.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/host/fractal/neighbours/findings_of.hpp"

namespace pxm::test {
namespace {

using host::ExactFindings;

/// x -> (x + d) / base in a line.
ExactFindings digits(long base, const std::vector<long>& list) {
    std::vector<std::string> maps;
    for (const long d : list)
        maps.push_back("scale: 1/" + std::to_string(base) + " translate: " + std::to_string(d) +
                       "/" + std::to_string(base) + ",0,0");
    return exact_of(system_of(maps));
}

void expect_pieces(const ExactFindings& found, std::size_t number) {
    EXPECT_EQ(found.components.value, number) << found.components.why;
    EXPECT_EQ(found.infinite_components, false);
    EXPECT_EQ(found.connected.value, number == 1);
}

void expect_no_number(const ExactFindings& found) {
    EXPECT_FALSE(found.components.value) << found.components.why;
    EXPECT_EQ(found.infinite_components, true) << found.components.why;
    EXPECT_EQ(found.connected.value, false);
}

/// With a and b of 0 and 1, a + 8 b in base 4 is 2 b_1 and all digits a_i + 2 b_(i + 1): [0, 1] and
/// [2, 3].
TEST(LevelParts, two_intervals_are_two_pieces) {
    const ExactFindings found = digits(4, {0, 1, 8, 9});
    expect_pieces(found, 2);
    for (const std::size_t parts : found.parts_of_levels) EXPECT_EQ(parts, 2U);
    EXPECT_EQ(found.interior.value, true);
    EXPECT_NEAR(found.volume.value.value(), 2, 1e-9) << found.volume.why;
}

/// The same with 2 b in place of 8 b, and 0, 1, 2: an interval of 0 to 2, [Hata85].
TEST(LevelParts, one_interval_is_one_piece) { expect_pieces(digits(2, {0, 1, 2}), 1); }

/// In base 9, with a of 0, 1, 2 and b of 0, 3, 6, a + 9 b k: three intervals k apart.
TEST(LevelParts, three_intervals_are_three_pieces) {
    std::vector<long> list;
    for (const long a : {0, 1, 2})
        for (const long b : {0, 1, 2}) list.push_back(a + 27 * b);
    expect_pieces(digits(9, list), 3);
}

TEST(LevelParts, dust_and_lines_over_dust_have_no_number) {
    expect_no_number(digits(3, {0, 2}));
    std::vector<std::string> columns;
    for (const char* x : {"0", "2/3"})
        for (const char* y : {"0", "1/3", "2/3"})
            columns.push_back(std::string("scale: 1/3 translate: ") + x + "," + y + ",0");
    expect_no_number(exact_of(system_of(columns)));
}

/// Neighbours 0 and 1, 3 and 4 touch, and so do the last of one and the first of the next: parts of
/// two and of four cells, of which those of two at each level are copies of the first.
TEST(LevelParts, parts_that_hold_copies_of_themselves_have_no_number) {
    const ExactFindings found = digits(5, {0, 1, 3, 4});
    EXPECT_GT(found.touching, 0U);
    expect_no_number(found);
}

/// One map of two intervals: its only image hangs together, and falls apart a level further down.
TEST(LevelParts, pieces_within_one_image_are_counted_as_well) {
    std::vector<std::string> maps{"whole scale: 1/3"};
    std::string follow;
    for (const char* d : {"0", "1", "8", "9"}) {
        maps.push_back(std::string("d") + d + " scale: 1/4 translate: " + d + "/4,0,0");
        follow += std::string("follow: d") + d + " -> d0,d1,d8,d9 ";
    }
    expect_pieces(exact_of(system_of(maps, follow + "follow: whole -> d0,d1,d8,d9 start: whole ")),
                  2);
}

}  // namespace
}  // namespace pxm::test
