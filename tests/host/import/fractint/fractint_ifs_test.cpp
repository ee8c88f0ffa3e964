#include "host/import/fractint/fractint_ifs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "host/math/lipschitz.hpp"
#include "host/scene/parse/parser.hpp"
#include "tests/support/paths.hpp"

namespace pxm::host {
namespace {

using testing::ElementsAre;

/// Everything that is wrong with a file and its entries.
std::string complaints(const std::string& text) {
    Diagnostics diagnostics;
    for (const FractintIfs& ifs : parse_fractint_ifs(text, diagnostics))
        diagnostics.append(ifs.entry.diagnostics);
    return diagnostics.text({{"f.ifs", text}});
}

FractintIfs only(const std::string& text) {
    EXPECT_EQ(complaints(text), "");
    Diagnostics diagnostics;
    auto list = parse_fractint_ifs(text, diagnostics);
    EXPECT_EQ(list.size(), 1U);
    return list.at(0);
}

std::vector<std::string> names(const std::string& text) {
    Diagnostics diagnostics;
    std::vector<std::string> list;
    for (const FractintIfs& ifs : parse_fractint_ifs(text, diagnostics))
        list.push_back(ifs.entry.name);
    return list;
}

Affine map(const FractintIfs& ifs, std::size_t index) {
    return compose(fractint_maps(ifs).maps.at(index).commands);
}

TEST(FractintIfs, a_map_moves_points_as_fractint_does) {
    const Affine w = map(only("t { 1 2 3 4 5 6 .5 }"), 0);
    const glm::dvec3 image = w.point({10, 100, 0});
    EXPECT_EQ(image, glm::dvec3(1 * 10 + 2 * 100 + 5, 3 * 10 + 4 * 100 + 6, 0));
}

// Its z points away from the viewer: iterated-dynamics 6caa386, libid/geometry/3d.cpp,
// perspective() refuses points whose z is not above that of the eye, and libid/fractals/lorenz.cpp,
// float_view_transf3d(), puts the eye at the smaller z.
TEST(FractintIfs, a_solid_map_has_the_axes_of_the_scene) {
    const Affine w = map(only("t (3D) { 1 2 3 4 5 6 7 8 9 10 11 12 .5 }"), 0);
    const glm::dvec3 x{10, 100, 1000};
    const glm::dvec3 image = w.point(x);
    EXPECT_EQ(image.x, 1 * x.x + 2 * x.y + 3 * x.z + 10);
    EXPECT_EQ(image.y, 4 * x.x + 5 * x.y + 6 * x.z + 11);
    EXPECT_EQ(image.z, 7 * x.x + 8 * x.y + 9 * x.z + 12);
}

TEST(FractintIfs, the_plane_is_as_thin_as_the_map_is_small) {
    EXPECT_NEAR(map(only("t { .5 0 0 .125 0 0 1 }"), 0).linear[2][2], 0.25, 1e-16);
    EXPECT_EQ(map(only("stem { 0 0 0 .16 0 0 1 }"), 0).linear[2][2], 0.16);
    EXPECT_EQ(map(only("point { 0 0 0 0 3 4 1 }"), 0).linear[2][2], 0.5);
    // Thickness never decides a Lipschitz constant.
    const Affine w = map(only("t { .3 -.4 .9 .1 0 0 1 }"), 0);
    EXPECT_LE(w.linear[2][2], lipschitz_constant(w));
}

TEST(FractintIfs, probabilities_are_weights) {
    EXPECT_EQ(fractint_maps(only("t { .5 0 0 .5 0 0 .25 .5 0 0 .5 1 0 0 }")).maps[0].weight, 0.25);
    EXPECT_EQ(fractint_maps(only("t { .5 0 0 .5 0 0 .25 .5 0 0 .5 1 0 0 }")).maps[1].weight, 0.0);
}

TEST(FractintIfs, lines_without_a_probability_are_maps_without_a_weight) {
    const FractintIfs flat = only("t {\n.5 0 0 .5 0 0\n.5 0 0 .5 1, 0\n}");
    ASSERT_EQ(fractint_maps(flat).maps.size(), 2U);
    EXPECT_EQ(fractint_maps(flat).maps[1].weight, std::nullopt);
    EXPECT_EQ(map(flat, 1).translation, glm::dvec3(1, 0, 0));
    const FractintIfs solid = only("t (3D) {\n.5 0 0 0 .5 0 0 0 .5 1 2 3\n}");
    EXPECT_EQ(fractint_maps(solid).maps.at(0).weight, std::nullopt);
    EXPECT_EQ(map(solid, 0).translation, glm::dvec3(1, 2, 3));
}

TEST(FractintIfs, numbers_alone_are_one_entry_without_a_name) {
    const FractintIfs ifs = only("; the oldest form\n.5 0 0 .5 0 0 .5\n.5 0 0 .5 1 0 .5\n");
    EXPECT_EQ(ifs.entry.name, "");
    EXPECT_EQ(fractint_maps(ifs).maps.size(), 2U);
    EXPECT_THAT(names(".5 0 0 .5 0 0 1\nb { .5 0 0 .5 0 0 1 }"), ElementsAre("", "b"));
    EXPECT_EQ(complaints(".5 0 0 .5 0 0 .5\n.5 0 0 .5\n"),
              "f.ifs:2:1: error: map 2 has 4 of its 7 numbers (a b c d e f p)\n"
              "    .5 0 0 .5\n    ^");
}

TEST(FractintIfs, a_block_without_a_name_is_a_comment) {
    EXPECT_THAT(names("{ by hand }\na { .5 0 0 .5 0 0 1 }"), ElementsAre("a"));
}

TEST(FractintIfs, the_line_with_too_few_numbers_is_named) {
    EXPECT_EQ(complaints("t {\n.5 0 0 .5 0 0 1\n.5 0 0 .5 0 0\n.5 0 0 .5 0 0 1\n}"),
              "f.ifs:3:1: error: map 2 of \"t\" has 6 of its 7 numbers (a b c d e f p)\n"
              "    .5 0 0 .5 0 0\n    ^");
}

TEST(FractintIfs, numbers_are_read_as_people_write_them) {
    const FractintIfs ifs = only("t{ .16 -.2 +1e-3 5. 1E2 -0 ,.5 }");
    EXPECT_THAT(ifs.numbers, ElementsAre(.16, -.2, 1e-3, 5., 100., 0., .5));
}

TEST(FractintIfs, spacing_line_ends_and_case_do_not_matter) {
    const FractintIfs a = only("t (3d) {\r\n1 0 0\r\n0 1 0 ; rows\r\n0 0 1 0 0 0 1\r\n}\r\n");
    EXPECT_FALSE(a.flat);
    EXPECT_EQ(a.numbers.size(), 13U);
    EXPECT_FALSE(only("\xef\xbb\xbft(3D){1 0 0 0 1 0 0 0 1 0 0 0 1}").flat);
    EXPECT_EQ(only("t\n\n{\n.5\n0\n0\n.5\n0\n0\n1\n\n}\x1a").entry.name, "t");
}

TEST(FractintIfs, a_file_may_hold_several_entries_also_on_one_line) {
    const std::string maps = "{ .5 0 0 .5 0 0 1 }";
    EXPECT_THAT(names("a " + maps + " b" + maps + "\nComment { b, not this: 1 2 }"),
                ElementsAre("a", "b"));
    EXPECT_THAT(names("comment { x }\n3dfern-2 " + maps + "; c " + maps + "\nd" + maps),
                ElementsAre("3dfern-2", "d"));
}

TEST(FractintIfs, mistakes_are_told_with_their_place) {
    EXPECT_EQ(complaints("t {\n .5 0 0 .5 0 0 1\n .5 0 0\n}"),
              "f.ifs:3:2: error: map 2 of \"t\" has 3 of its 7 numbers (a b c d e f p)\n"
              "    .5 0 0\n    ^");
    EXPECT_EQ(complaints("t (3D) { 1 2 }"),
              "f.ifs:1:10: error: map 1 of \"t\" has 2 of its 13 numbers (3x3 by rows, "
              "translation, p)\n    t (3D) { 1 2 }\n             ^");
    EXPECT_EQ(complaints("t { .5 O 0 .5 0 0 1 }"),
              "f.ifs:1:8: error: expected a number or '}', found 'O'\n"
              "    t { .5 O 0 .5 0 0 1 }\n           ^");
    EXPECT_EQ(complaints("t { .5 0 0 .5 0 0 -1 }"),
              "f.ifs:1:19: error: the probability of map 1 is -1: it must not be negative\n"
              "    t { .5 0 0 .5 0 0 -1 }\n                      ^");
    EXPECT_EQ(complaints("t { }"), "f.ifs:1:1: error: entry \"t\" has no maps\n    t { }\n    ^");
    EXPECT_EQ(complaints("t { 1 0 0 1 0 0 1"),
              "f.ifs:1:1: error: entry \"t\" has no closing '}'\n    t { 1 0 0 1 0 0 1\n    ^");
    EXPECT_EQ(complaints("t { 1 0 0 1 0 0 1\nu { 1 0 0 1 0 0 1 }"),
              "f.ifs:1:1: error: entry \"t\" has no closing '}'\n    t { 1 0 0 1 0 0 1\n    ^");
    EXPECT_EQ(complaints("t (4D) { 1 0 0 1 0 0 1 }"),
              "f.ifs:1:1: error: unknown kind (4D): expected (3D)\n"
              "    t (4D) { 1 0 0 1 0 0 1 }\n    ^");
    EXPECT_EQ(complaints("hello"),
              "f.ifs:1:1: error: expected '{' after the name \"hello\"\n    hello\n    ^");
    EXPECT_THAT(complaints("t { 1e999 0 0 1 0 0 1 }"), testing::HasSubstr("found '1e999'"));
    EXPECT_THAT(complaints("t { nan 0 0 1 0 0 1 }"), testing::HasSubstr("found 'nan'"));
}

TEST(FractintIfs, a_broken_entry_does_not_spoil_the_next) {
    Diagnostics diagnostics;
    const auto list = parse_fractint_ifs("a { 1 x 3 }\nb { .5 0 0 .5 0 0 1 }", diagnostics);
    ASSERT_EQ(list.size(), 2U);
    EXPECT_TRUE(list[0].entry.diagnostics.has_errors());
    EXPECT_FALSE(list[1].entry.diagnostics.has_errors());
    EXPECT_FALSE(diagnostics.has_errors());
}

}  // namespace
}  // namespace pxm::host
