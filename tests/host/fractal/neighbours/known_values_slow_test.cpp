// Numbers that others have found, each with its source, against what exact numbers decide here.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/host/fractal/neighbours/findings_of.hpp"

namespace pxm::test {
namespace {

using host::ExactFindings;

constexpr double digits = 2e-6;  // the sources give six or seven

void expect_tile(const ExactFindings& found, double boundary) {
    EXPECT_EQ(found.open_set.value, true) << found.open_set.why;
    EXPECT_EQ(found.interior.value, true) << found.interior.why;
    ASSERT_TRUE(found.hausdorff.value) << found.hausdorff.why;
    EXPECT_NEAR(*found.hausdorff.value, 2, 1e-9);
    ASSERT_TRUE(found.boundary.value) << found.boundary.why;
    EXPECT_NEAR(*found.boundary.value, boundary, digits);
}

// [NW01], example: log((3 + sqrt 5)/2) / log 3; maps x/3, (x + 1)/3, (x + 3)/3.
TEST(KnownValues, cells_that_coincide_lower_the_dimension) {
    const ExactFindings found = exact_of(
        system_of({"scale: 1/3", "scale: 1/3 translate: 1/3,0,0", "scale: 1/3 translate: 1,0,0"}));
    EXPECT_EQ(found.overlaps.value, true);
    EXPECT_EQ(found.overlapping_words[0], (std::vector<int>{0, 2}));
    EXPECT_EQ(found.overlapping_words[1], (std::vector<int>{1, 0}));
    EXPECT_EQ(found.open_set.value, false);
    EXPECT_NEAR(found.hausdorff.value.value(), 0.876036, digits);
    EXPECT_EQ(found.interior.value, false);
}

// [BMS04]: golden gaskets, 1.93063...
TEST(KnownValues, golden_gasket) {
    const ExactFindings found =
        exact_of(system_of({"scale: 1/phi", "scale: 1/phi translate: 1-1/phi,0,0",
                            "scale: 1/phi translate: (1-1/phi)/2,(1-1/phi)*sqrt(3)/2,0"}));
    EXPECT_EQ(found.overlaps.value, true);
    EXPECT_NEAR(found.hausdorff.value.value(), 1.93063, 1e-5);
    EXPECT_EQ(found.connected.value, true);
}

// [DKV00]: 1.523627 for both dragons; the twindragon has six neighbours [BM09].
TEST(KnownValues, twindragon) {
    const ExactFindings found = exact_of(system_of(
        {"scale: 1/sqrt(2) rotate: z,45", "scale: 1/sqrt(2) rotate: z,45 translate: 1/2,1/2,0"}));
    expect_tile(found, 1.523627);
    EXPECT_EQ(found.touching, 6U);
    EXPECT_EQ(found.connected.value, true);
}

TEST(KnownValues, heighway_dragon) {
    expect_tile(exact_of(system_of({"scale: 1/sqrt(2) rotate: z,45",
                                    "scale: 1/sqrt(2) rotate: z,135 translate: 1,0,0"})),
                1.523627);
}

// [Ryde21]: the boundary of a finite terdragon has 3 * 2^k edges, each of 1 / sqrt(3)^k: log 4 /
// log 3.
TEST(KnownValues, terdragon) {
    expect_tile(exact_of(system_of({"scale: 1/sqrt(3) rotate: z,30",
                                    "scale: 1/sqrt(3) rotate: z,-90 translate: 1/2,sqrt(3)/6,0",
                                    "scale: 1/sqrt(3) rotate: z,30 translate: 1/2,-sqrt(3)/6,0"})),
                1.261860);
}

// [DK99], [SW99]: 1.934007.
TEST(KnownValues, levy_dragon) {
    expect_tile(exact_of(system_of({"scale: 1/sqrt(2) rotate: z,45",
                                    "scale: 1/sqrt(2) rotate: z,-45 translate: 1/2,1/2,0"})),
                1.934007);
}

// [Mandelbrot82]: its coast is of log 9 / log 7; its six neighbours are those of a hexagon.
TEST(KnownValues, gosper_island) {
    std::vector<std::string> maps;
    for (const char* digit : {"0;0", "1;0", "1/2;sqrt(3)/2", "-1/2;sqrt(3)/2", "-1;0",
                              "-1/2;-sqrt(3)/2", "1/2;-sqrt(3)/2"}) {
        const std::string text = digit;
        const std::string x = "(" + text.substr(0, text.find(';')) + ")";
        const std::string y = "(" + text.substr(text.find(';') + 1) + ")";
        maps.push_back("matrix: 5/14,-sqrt(3)/14,0, sqrt(3)/14,5/14,0, 0,0,1/sqrt(7), (5*" + x +
                       "+sqrt(3)*" + y + ")/14,(5*" + y + "-sqrt(3)*" + x + ")/14,0");
    }
    const ExactFindings found = exact_of(system_of(maps));
    expect_tile(found, 1.129150);
    EXPECT_EQ(found.touching, 6U);
}

// [Mandelbrot82]: of dimension log 4 / log 2. Twelve neighbours: any of the four corners of one
// cell at any of the three others of the next.
TEST(KnownValues, sierpinski_tetrahedron) {
    const ExactFindings found = exact_of(system_of(
        {"scale: 1/2", "scale: 1/2 translate: 1/2,0,0", "scale: 1/2 translate: 1/4,sqrt(3)/4,0",
         "scale: 1/2 translate: 1/4,sqrt(3)/12,sqrt(6)/6"}));
    EXPECT_EQ(found.touching, 12U);
    EXPECT_EQ(found.open_set.value, true);
    EXPECT_EQ(found.connected.value, true);
    EXPECT_NEAR(found.hausdorff.value.value(), 2, 1e-9);
    EXPECT_EQ(found.interior.value, false);
}

// [Mandelbrot82]: log 20 / log 3. Cells are cubes of a grid, each of which has 26 around it.
TEST(KnownValues, menger_sponge) {
    std::vector<std::string> maps;
    for (int i = 0; i < 27; ++i) {
        const int x = i % 3, y = i / 3 % 3, z = i / 9;
        if ((x == 1) + (y == 1) + (z == 1) > 1) continue;
        maps.push_back("scale: 1/3 translate: " + std::to_string(x) + "/3," + std::to_string(y) +
                       "/3," + std::to_string(z) + "/3");
    }
    const ExactFindings found = exact_of(system_of(maps));
    EXPECT_NEAR(found.hausdorff.value.value(), std::log(20) / std::log(3), 1e-9);
    EXPECT_EQ(found.connected.value, true);
    EXPECT_EQ(found.touching, 26U);
}

// 24 rings of a fifth in a ring, each through the next, none touches: log 24 / log 5, a dust
// [Hutchinson81].
TEST(KnownValues, antoines_necklace) {
    std::vector<std::string> maps;
    for (int k = 0; k < 24; ++k)
        maps.push_back("scale: 1/5 rotate: y," + std::to_string(90 * (k % 2)) +
                       " translate: 1,0,0 rotate: z," + std::to_string(15 * k));
    const ExactFindings found = exact_of(system_of(maps));
    EXPECT_NEAR(found.hausdorff.value.value(), 1.974636, digits);
    EXPECT_EQ(found.totally_disconnected.value, true);
    EXPECT_EQ(found.open_set.value, true);
    EXPECT_EQ(found.connected.value, false);
}

// [MW88]: the d where the matrix of sums has spectral radius 1, (1 - 4/3^d)(1 - 3/2^d) = 1/6^d.
TEST(KnownValues, a_graph_of_koch_and_sierpinski) {
    const ExactFindings found = exact_of(
        system_of({"k1 scale: 1/3", "k2 scale: 1/3 rotate: z,60 translate: 1/3,0,0",
                   "k3 scale: 1/3 rotate: z,-60 translate: 1/2,sqrt(3)/6,0",
                   "k4 scale: 1/3 translate: 2/3,0,0", "ks scale: 1/3 translate: 0,0,1",
                   "s1 scale: 1/2", "s2 scale: 1/2 translate: 1/2,0,0",
                   "s3 scale: 1/2 translate: 1/4,sqrt(3)/4,0", "sk scale: 1/2 translate: 0,0,1"},
                  "follow: k1 -> k1,k2,k3,k4,ks follow: k2 -> k1,k2,k3,k4,ks "
                  "follow: k3 -> k1,k2,k3,k4,ks follow: k4 -> k1,k2,k3,k4,ks "
                  "follow: ks -> s1,s2,s3,sk follow: s1 -> s1,s2,s3,sk follow: s2 -> s1,s2,s3,sk "
                  "follow: s3 -> s1,s2,s3,sk follow: sk -> k1,k2,k3,k4,ks start: k1,k2,k3,k4,ks "));
    EXPECT_EQ(found.open_set.value, true) << found.open_set.why;
    EXPECT_NEAR(found.hausdorff.value.value(), 1.7465453, digits);
}

// [Hutchinson81], Moran's equation: 8 k^d + 12 k^(2 d) = 1 with k = sqrt(2) - 1.
TEST(KnownValues, jerusalem_cube) {
    std::vector<std::string> maps;
    const std::string r = "(sqrt(2)-1)";
    const char* corners[] = {"0", "(2-sqrt(2))"};
    const char* edges[] = {"0", "(2*sqrt(2)-2)"};
    for (const char* a : corners)
        for (const char* b : corners)
            for (const char* c : corners)
                maps.push_back("scale: " + r + " translate: " + a + "," + b + "," + c);
    for (const std::string a : edges)
        for (const std::string b : edges)
            for (const std::string& place :
                 {r + "," + a + "," + b, a + "," + r + "," + b, a + "," + b + "," + r})
                maps.push_back("scale: " + r + "*" + r + " translate: " + place);
    const ExactFindings found = exact_of(system_of(maps));
    EXPECT_NEAR(found.hausdorff.value.value(), 2.5291208, digits);
    EXPECT_EQ(found.open_set.value, true);
    EXPECT_EQ(found.connected.value, true);
}

/// z = x^2 + y^2 over a square: four affine maps, no similitudes.
TEST(KnownValues, a_paraboloid_has_no_inside_and_hangs_together) {
    std::vector<std::string> maps;
    for (const int a : {0, 1})
        for (const int b : {0, 1}) {
            const std::string x = std::to_string(a), y = std::to_string(b);
            maps.push_back("matrix: 1/2,0," + x + "/2, 0,1/2," + y + "/2, 0,0,1/4, " + x + "/2," +
                           y + "/2," + std::to_string(a + b) + "/4");
        }
    const ExactFindings found = exact_of(system_of(maps));
    EXPECT_EQ(found.finite.value, true);
    EXPECT_EQ(found.touching, 8U);
    EXPECT_EQ(found.overlaps.value, false);
    EXPECT_EQ(found.connected.value, true);
    EXPECT_EQ(found.interior.value, false);
    EXPECT_FALSE(found.hausdorff.value);
}

/// Maps of a half of a triangular prism: eight fill it.
TEST(KnownValues, a_prism_of_eight_halves_has_inside) {
    std::vector<std::string> maps;
    for (const char* z : {"0", "1/2"})
        for (const char* place : {"0,0", "1/2,0", "1/4,sqrt(3)/4"})
            maps.push_back(std::string("scale: 1/2 translate: ") + place + "," + z);
    for (const char* z : {"0", "1/2"})
        maps.push_back(std::string("scale: 1/2 rotate: z,180 translate: 3/4,sqrt(3)/4,") + z);
    const ExactFindings found = exact_of(system_of(maps));
    EXPECT_EQ(found.open_set.value, true) << found.open_set.why;
    EXPECT_EQ(found.interior.value, true);
    EXPECT_NEAR(found.boundary.value.value(), 2, 1e-9);
}

/// [FFIW06]: the tribonacci tile, 1.093364; its maps turn by the complex root of x^3 =
/// x^2 + x + 1.
TEST(KnownValues, rauzy_fractal) {
    using namespace host::exact;
    WrittenMaps written;
    NumberField& field = written.field;
    Polynomial tribonacci;  // x^3 - x^2 - x - 1
    const Polynomial x = Polynomial::unknown();
    tribonacci = x * x * x - x * x - x - Polynomial(1);
    const Algebraic alpha = field.root(tribonacci, 1, 2);
    const Algebraic real = field.divide(field.subtract(whole(1), alpha), whole(2));
    const Algebraic imaginary = field.square_root(
        field.subtract(field.divide(whole(1), alpha), field.multiply(real, real)));
    const auto turn = [&](long offset) {
        Entries e;
        e[0] = {real, field.subtract(whole(0), imaginary), whole(0), whole(offset)};
        e[1] = {imaginary, real, whole(0), whole(0)};
        e[2][2] = imaginary;
        return e;
    };
    // R1 = b R1 + b R2 + b R3, R2 = b R1 + 1, R3 = b R2 + 1.
    host::Rifs rifs;
    const auto add = [&](long offset, int follow) {
        written.maps.push_back(turn(offset));
        const double c = field.approximate(real), s = field.approximate(imaginary);
        host::Affine map;
        map.linear = {glm::dvec3{c, s, 0}, glm::dvec3{-s, c, 0}, glm::dvec3{0, 0, s}};
        map.translation = {static_cast<double>(offset), 0, 0};
        rifs.maps.push_back(map);
        rifs.map_names.push_back(std::to_string(rifs.maps.size()));
        rifs.follow_of.push_back(follow);
    };
    add(0, 0);
    add(0, 1);
    add(0, 2);
    add(1, 0);
    add(1, 1);
    rifs.follow_sets = {{{0, 1, 2}}, {{3}}, {{4}}};
    const auto bounds = host::bound(rifs, host::prove_contraction(rifs));
    const ExactFindings found = host::find_exactly(std::move(written), rifs, bounds, {});
    EXPECT_EQ(found.degree, 6);
    expect_tile(found, 1.093364);
}

}  // namespace
}  // namespace pxm::test
