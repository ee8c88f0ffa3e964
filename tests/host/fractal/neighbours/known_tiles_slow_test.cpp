// Tiles that others have found, each with its source, and their areas and volumes.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <fstream>
#include <sstream>
#include <string>

#include "tests/host/fractal/neighbours/findings_of.hpp"
#include "tests/support/paths.hpp"

namespace pxm::test {
namespace {

using host::ExactFindings;

/// A system of tests/data/neighbours/known.pxm.
ExactFindings known(const std::string& name) {
    std::ifstream file(source_dir + "/tests/data/neighbours/known.pxm");
    std::stringstream all;
    all << file.rdbuf();
    const std::string text = all.str();
    const std::size_t begin = text.find("ifs " + name + " {");
    EXPECT_NE(begin, std::string::npos) << name;
    return exact_of(text.substr(begin, text.find("\n}", begin) + 3 - begin));
}

void expect_tile(const ExactFindings& found, int dimension) {
    EXPECT_EQ(found.open_set.value, true) << found.open_set.why;
    EXPECT_EQ(found.interior.value, true) << found.interior.why;
    EXPECT_NEAR(found.hausdorff.value.value(), dimension, 1e-9);
}

/// [IFSDB]: eight halves of a convex body of six corners. Its section at the height z is a triangle
/// at 0, one half and 1, of 2, 9/8 and 1/2, so that it has (2 + 4 * 9/8 + 1/2) / 6.
TEST(KnownTiles, mekhontsevs_wedge) {
    const ExactFindings found = known("wedge");
    expect_tile(found, 3);
    EXPECT_NEAR(found.boundary.value.value(), 2, 1e-9);
    EXPECT_NEAR(found.volume.value.value(), 7.0 / 6, 1e-12) << found.volume.why;
}

/// [IFSDB]: 13 neighbours, and a boundary of log x / log 3 where x is the largest root of
/// x^7 - 12 x^6 + 27 x^5 + 10 x^4 - 61 x^3 + 20 x^2 + 9 x - 18.
TEST(KnownTiles, a_tile_of_few_neighbours_and_much_boundary) {
    const ExactFindings found = known("hd_tile");
    expect_tile(found, 2);
    EXPECT_EQ(found.touching, 13U);
    const auto polynomial = [](double x) {
        double value = 0;
        for (const double c : {1, -12, 27, 10, -61, 20, 9, -18}) value = value * x + c;
        return value;
    };
    double low = 8.5, high = 9;
    for (int i = 0; i < 60; ++i) (polynomial((low + high) / 2) < 0 ? low : high) = (low + high) / 2;
    EXPECT_NEAR(found.boundary.value.value(), std::log(low) / std::log(3.0), 1e-9);
}

/// [BGS23], maps from [IFSDB]: the self-similar relative of the hat's tiling has four pieces, of
/// which each is of dimension 2, and phi^-2 for ratio.
TEST(KnownTiles, the_hats_four_pieces) {
    const ExactFindings found = known("cap");
    expect_tile(found, 2);
    EXPECT_EQ(found.degree, 4);
    EXPECT_EQ(found.overlaps.value, false);
    EXPECT_EQ(found.connected.value, true);
    ASSERT_TRUE(found.volume_between) << found.volume.why;
    EXPECT_GT(found.volume_between->low, 0);
}

/// Half the unit square on the line between its ends; the twindragon is two of them.
TEST(KnownTiles, heighways_dragon_has_half_the_twindragons_area) {
    EXPECT_NEAR(known("twindragon").volume.value.value(), 1, 1e-12);
    const ExactFindings found = known("heighway");
    ASSERT_TRUE(found.volume.value) << found.volume.why;
    EXPECT_NEAR(*found.volume.value, 0.5, 1e-12) << found.volume.why;
}

/// An L of three unit squares.
TEST(KnownTiles, a_tile_that_is_turned_lies_between_two_volumes) {
    const ExactFindings found = known("rep_tile_l");
    expect_tile(found, 2);
    if (found.volume.value) {
        EXPECT_NEAR(*found.volume.value, 3, 1e-9) << found.volume.why;
    } else {
        ASSERT_TRUE(found.volume_between) << found.volume.why;
        EXPECT_LE(found.volume_between->low, 3);
        EXPECT_GE(found.volume_between->high, 3);
        EXPECT_LT(found.volume_between->high - found.volume_between->low, 0.1);
    }
}

TEST(KnownTiles, convex_bodies_have_the_volumes_of_geometry) {
    EXPECT_NEAR(known("cube").volume.value.value(), 1, 1e-12);
    EXPECT_NEAR(known("square").volume.value.value(), 1, 1e-12);
    EXPECT_NEAR(known("prism").volume.value.value(), std::sqrt(3) / 4, 1e-12);
    EXPECT_NEAR(known("bernoulli_golden").volume.value.value(), 1, 1e-12);
}

}  // namespace
}  // namespace pxm::test
