// Self-affine tiles: an inside by counting digits, and its volume.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "tests/host/fractal/neighbours/findings_of.hpp"

namespace pxm::test {
namespace {

using host::ExactFindings;

/// A map of the plane: its linear part's rows, as the scene writes them, and where 0 goes.
std::string plane_map(const std::string& first, const std::string& second, const std::string& x,
                      const std::string& y) {
    return "matrix: " + first + ",0, " + second + ",0, 0,0,1/2, " + x + "," + y + ",0";
}

/// (x, y) -> ((x + i) / 2, (y + j) / 3).
ExactFindings halves_and_thirds(const std::vector<std::string>& rows) {
    std::vector<std::string> maps;
    for (const char* column : {"0", "1"})
        for (const std::string& row : rows)
            maps.push_back(plane_map("1/2,0", "0,1/3", std::string(column) + "/2", row + "/3"));
    return exact_of(system_of(maps));
}

void expect_tile(const ExactFindings& found, double area) {
    EXPECT_EQ(found.open_set.value, true) << found.open_set.why;
    EXPECT_EQ(found.interior.value, true) << found.interior.why;
    EXPECT_EQ(found.hausdorff.value, 2) << found.hausdorff.why;
    ASSERT_TRUE(found.volume.value) << found.volume.why;
    EXPECT_NEAR(*found.volume.value, area, 1e-9) << found.volume.why;
    EXPECT_FALSE(found.boundary.value);
}

TEST(AffineTileSlow, a_square_of_halves_and_thirds) {
    expect_tile(halves_and_thirds({"0", "1", "2"}), 1);
}

/// 0, 1 and 5 leave each remainder of 3 once and have no common factor: a set of length 1, by all
/// whole numbers' copies of which the line is covered.
TEST(AffineTileSlow, rows_that_fall_apart_have_the_square_s_area) {
    const ExactFindings found = halves_and_thirds({"0", "1", "5"});
    expect_tile(found, 1);
    EXPECT_EQ(found.connected.value, false);
}

TEST(AffineTileSlow, rows_whose_words_agree_have_no_inside) {
    const ExactFindings found = halves_and_thirds({"0", "1", "3"});
    EXPECT_EQ(found.overlaps.value, true);
    EXPECT_EQ(found.open_set.value, false);
    EXPECT_EQ(found.interior.value, false) << found.interior.why;
}

/// No power of the linear part is that of a similitude. Digits 0 and 1 on both axes are all there
/// are of the lattice modulo 2 x + y, 2 y.
TEST(AffineTileSlow, a_sheared_one) {
    std::vector<std::string> maps;
    for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {0, 1}, {1, 1}}) {
        // (x, y) goes to (x / 2 - y / 4, y / 2).
        const std::string a = "(" + std::to_string(2 * x - y) + ")/4", b = std::to_string(y) + "/2";
        maps.push_back(plane_map("1/2,0", "-1/4,1/2", a, b));
    }
    expect_tile(exact_of(system_of(maps)), 1);
}

/// Its digits and their multiples by 2 and 3 come as near to each other as one likes.
TEST(AffineTileSlow, digits_of_no_lattice_decide_nothing) {
    const ExactFindings found = halves_and_thirds({"0", "1", "sqrt(2)"});
    EXPECT_FALSE(found.open_set.value);
    EXPECT_FALSE(found.interior.value);
}

}  // namespace
}  // namespace pxm::test
