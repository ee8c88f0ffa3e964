// What `pxm inspect` says of a scene's numbers, and what it does not.
#include "host/inspect/exact_facts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "host/inspect/inspect_json.hpp"
#include "host/inspect/neighbour_files.hpp"
#include "tests/host/inspect/inspect_scene.hpp"
#include "tests/host/inspect/json_keys.hpp"

namespace pxm::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

json system_json(const std::string& text) {
    const json found = json::parse(host::inspect_json(inspect_text_of("a.pxm", text)));
    expect_ifs_keys(found["ifs"]["a"], text);
    return found["ifs"]["a"];
}

TEST(ExactFacts, the_same_numbers_in_other_words_are_the_same_system) {
    const json first = system_json(
        "ifs a { newmap scale: 1/phi newmap scale: 1/phi translate: 1,0,0\n"
        "newmap scale: 1/phi translate: 0,1,0 }");
    const json second = system_json(
        "let r = 2*cos(72)\n"
        "ifs a { newmap scale: r newmap scale: r translate: 1,0,0\n"
        "newmap scale: (sqrt(5)-1)/2 translate: 0,1,0 }");
    for (const char* key : {"exact_overlaps", "overlapping_words", "connected", "interior"})
        EXPECT_EQ(first[key], second[key]) << key;
    EXPECT_EQ(first["exact_overlaps"], true);
    EXPECT_EQ(first["neighbours"]["types"], second["neighbours"]["types"]);
    EXPECT_EQ(first["dimension"]["hausdorff"], second["dimension"]["hausdorff"]);
    EXPECT_EQ(first["dimension"]["hausdorff_exact"], true);
}

// Six digits of 1/phi are another number: its words are no longer the same map.
TEST(ExactFacts, a_decimal_is_not_what_it_is_near_to) {
    const json found = system_json(
        "ifs a { newmap scale: 0.618034 newmap scale: 0.618034 translate: 1,0,0\n"
        "newmap scale: 0.618034 translate: 0,1,0 }");
    EXPECT_NE(found["exact_overlaps"], true);
    EXPECT_EQ(found["dimension"]["hausdorff_exact"], false);
}

TEST(ExactFacts, numbers_of_no_field_are_known_in_intervals) {
    struct Case {
        const char* scale;
        int digits;
    };
    for (const auto& [scale, digits] :
         {Case{"1/pi", 60}, {"sqrt(2)/3*cos(1)", 60}, {"key(0.5: 0 -> 0.3, 1 -> 0.2)", 12}}) {
        const json found = system_json(std::string("ifs a { newmap scale: ") + scale +
                                       " newmap scale: 1/4 translate: 1,0,0 }");
        EXPECT_TRUE(found["neighbours"]["field_degree"].is_null()) << scale;
        EXPECT_EQ(found["neighbours"]["decided_by"], "intervals") << scale;
        EXPECT_EQ(found["neighbours"]["interval_digits"], digits) << scale;
        EXPECT_EQ(found["exact_overlaps"], false) << scale;
        EXPECT_THAT(found["exact_overlaps_why"].get<std::string>(),
                    HasSubstr("in intervals of " + std::to_string(digits) + " digits"));
        EXPECT_EQ(found["dimension"]["hausdorff_exact"], false) << scale;
        EXPECT_EQ(found["dimension"]["order"][0]["known"], digits == 60 ? "proven" : "numerical")
            << scale;
    }
}

// Common points and equal words are there, and intervals do not tell.
TEST(ExactFacts, intervals_leave_open_what_touches) {
    const json found = system_json(
        "ifs a { newmap scale: 1/2 newmap scale: 1/2 translate: 1/2*(pi/pi),0,0\n"
        "newmap scale: 1/2 translate: 0,1/2,0 }");
    for (const char* key : {"exact_overlaps", "connected"}) {
        EXPECT_TRUE(found[key].is_null()) << key;
        EXPECT_THAT(found[std::string(key) + "_why"].get<std::string>(),
                    HasSubstr("not told apart, in intervals of 60 digits"));
    }
    EXPECT_TRUE(found["neighbours"]["finite"].is_null());
    EXPECT_EQ(found["interior"], false);
}

// Of the paraboloid z = x^2 + y^2 over the unit square, by four affine maps: all that is known.
TEST(ExactFacts, a_paraboloid_is_a_surface_of_its_affinity_dimension_at_most) {
    std::string text = "ifs a {\n";
    for (const int a : {0, 1})
        for (const int b : {0, 1}) {
            const std::string x = std::to_string(a), y = std::to_string(b);
            text += "newmap matrix: 1/2,0," + x + "/2, 0,1/2," + y + "/2, 0,0,1/4, " + x + "/2," +
                    y + "/2," + std::to_string(a + b) + "/4\n";
        }
    const json found = system_json(text + "}");
    EXPECT_EQ(found["connected"], true);
    EXPECT_EQ(found["exact_overlaps"], false);
    EXPECT_EQ(found["interior"], false);
    EXPECT_EQ(found["volume"], 0);
    EXPECT_EQ(found["subspace"]["dimension"], 3);
    EXPECT_EQ(found["subspace"]["exact"], true);
    // From (0, 0, 0) to (1, 1, 2).
    EXPECT_LE(found["diameter"]["lower"].get<double>(), std::sqrt(6));
    EXPECT_GE(found["diameter"]["upper"].get<double>(), std::sqrt(6));
    EXPECT_NEAR(found["diameter"]["value"].get<double>(), std::sqrt(6), 1e-5);
    // The mean of x^2 is 1/3; x and y spread as on the square.
    EXPECT_NEAR(found["centroid"][0].get<double>(), 0.5, found["centroid_error"].get<double>());
    EXPECT_NEAR(found["centroid"][2].get<double>(), 2.0 / 3, found["centroid_error"].get<double>());
    EXPECT_LT(found["centroid_error"].get<double>(), 1e-11);
    ASSERT_TRUE(found["dimension"]["hausdorff"].is_number()) << found["dimension"];
    EXPECT_NEAR(found["dimension"]["hausdorff"].get<double>(), 2, 1e-9);
    EXPECT_EQ(found["dimension"]["hausdorff_exact"], true);
    EXPECT_THAT(found["dimension"]["hausdorff_why"].get<std::string>(),
                HasSubstr("no less than that of its projection to x and y"));
    EXPECT_NEAR(found["boundary"]["dimension"].get<double>(), 2, 1e-9);
}

TEST(ExactFacts, numbers_that_double_their_digits_are_taken_as_intervals) {
    std::string text = "let n0 = 0.99\n";
    for (int i = 1; i < 80; ++i) {
        const std::string before = "n" + std::to_string(i - 1);
        text += "let n" + std::to_string(i) + " = " + before + "*" + before + "\n";
    }
    const json found =
        system_json(text + "ifs a { newmap scale: 1/2+n79 newmap scale: 1/2 translate: 1,0,0 }");
    EXPECT_EQ(found["neighbours"]["numbers"],
              "its numbers have too many digits: intervals of 60 digits");
}

// The area of the twindragon is that of the lattice of whole numbers that its copies tile by.
TEST(ExactFacts, a_tile_has_the_volume_of_its_lattice) {
    const json dragon = system_json(
        "ifs a { newmap scale: 1/sqrt(2) rotate: z,45\n"
        "newmap scale: 1/sqrt(2) rotate: z,45 translate: 1/2,1/2,0 }");
    EXPECT_EQ(dragon["interior"], true);
    EXPECT_NEAR(dragon["volume"].get<double>(), 1, 1e-12) << dragon["volume_why"];
    const json square = system_json(
        "ifs a { newmap scale: 1/2 newmap scale: 1/2 translate: 3/2,0,0\n"
        "newmap scale: 1/2 translate: 0,1,0 newmap scale: 1/2 translate: 3/2,1,0 }");
    EXPECT_NEAR(square["volume"].get<double>(), 6, 1e-12) << square["volume_why"];
    EXPECT_NEAR(square["centroid"][0].get<double>(), 1.5, 1e-12);
    EXPECT_NEAR(square["centroid"][1].get<double>(), 1, 1e-12);
    EXPECT_NEAR(square["principal_axes"][0]["variance"].get<double>(), 9.0 / 12, 1e-12);
    EXPECT_NEAR(square["diameter"]["value"].get<double>(), std::sqrt(13), 1e-5);
}

TEST(ExactFacts, the_boundary_of_a_tile_is_a_scene_of_that_dimension) {
    const host::Inspection dragon =
        inspect_text_of("a.pxm",
                        "ifs a { newmap scale: 1/sqrt(2) rotate: z,45\n"
                        "newmap scale: 1/sqrt(2) rotate: z,45 translate: 1/2,1/2,0 }");
    const std::string scene = host::boundary_scene(dragon.ifs.front());
    const host::Inspection boundary = inspect_text_of("boundary.pxm", scene);
    ASSERT_TRUE(boundary.ifs.front().dimensions.similarity);
    EXPECT_NEAR(boundary.ifs.front().dimensions.similarity->middle(),
                *dragon.ifs.front().exact.boundary.value, 1e-9);
    EXPECT_EQ(host::neighbour_files(dragon).size(), 4U);
}

TEST(ExactFacts, a_system_without_duplicates_is_a_scene_of_that_dimension) {
    const host::Inspection gasket =
        inspect_text_of("a.pxm",
                        "ifs a { newmap scale: 1/phi newmap scale: 1/phi translate: 1,0,0\n"
                        "newmap scale: 1/phi translate: 0,1,0 }");
    const std::string scene = host::distinct_scene(gasket.ifs.front());
    const host::Inspection distinct = inspect_text_of("distinct.pxm", scene);
    ASSERT_TRUE(distinct.ifs.front().dimensions.similarity);
    EXPECT_NEAR(distinct.ifs.front().dimensions.similarity->middle(),
                *gasket.ifs.front().exact.hausdorff.value, 1e-9);
    const host::Inspection none = inspect_text_of(
        "b.pxm", "ifs b { newmap scale: 1/3 newmap scale: 1/3 translate: 2/3,0,0 }");
    EXPECT_EQ(host::distinct_scene(none.ifs.front()), "");
}

}  // namespace
}  // namespace pxm::test
