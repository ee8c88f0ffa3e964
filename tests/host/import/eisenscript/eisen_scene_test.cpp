// EisenScript: boxes and spheres stand where Structure Synth puts them.
#include "host/import/eisenscript/eisen_scene.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <random>
#include <string>
#include <variant>
#include <vector>

#include "host/error.hpp"
#include "host/import/import.hpp"
#include "host/math/affine.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {
namespace {

using testing::HasSubstr;

Imported imported(const std::string& text, std::uint64_t seed = 1) {
    return import_eisenscript({"f.es", text}, seed);
}

struct Refusal {
    std::optional<ErrorKind> kind;
    std::string text;
};

Refusal refusal(const std::string& text) {
    try {
        (void)imported(text);
        return {};
    } catch (const Error& error) {
        return {error.kind(), error.what()};
    }
}

struct PlacedBox {
    glm::dvec3 middle;
    glm::dvec3 edge;  // where its first edge goes
};

/// Every box of the scene, as the program has them: z toward the viewer.
std::vector<PlacedBox> boxes(const Imported& made) {
    const IfsBlock& ifs = made.scene.ifs[0];
    const std::size_t first_corner = ifs.maps.size() - 8;
    std::vector<PlacedBox> found;
    const auto walk = [&](const auto& self, std::size_t map, const Affine& place) -> void {
        const Affine here = then(compose(ifs.maps[map].commands), place);
        for (const MapReference& next : ifs.follow[map].followers) {
            const auto number = static_cast<std::size_t>(std::get<long>(next.map)) - 1;
            if (number < first_corner) {
                self(self, number, here);
                continue;
            }
            const glm::dvec3 middle = here.point({0.5, 0.5, -0.5});
            const glm::dvec3 edge = here.direction({1, 0, 0});
            found.push_back({{middle.x, middle.y, -middle.z}, {edge.x, edge.y, -edge.z}});
            return;
        }
    };
    for (const MapReference& start : ifs.start)
        walk(walk, static_cast<std::size_t>(std::get<long>(start.map)) - 1, Affine{});
    return found;
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b) {
    EXPECT_NEAR(a.x, b.x, 1e-9);
    EXPECT_NEAR(a.y, b.y, 1e-9);
    EXPECT_NEAR(a.z, b.z, 1e-9);
}

TEST(EisenScript, a_box_is_the_unit_cube) {
    const std::vector<PlacedBox> one = boxes(imported("box"));
    ASSERT_EQ(one.size(), 1U);
    expect_near(one[0].middle, {0.5, 0.5, 0.5});
}

TEST(EisenScript, transformations_are_about_the_cubes_middle_in_the_order_of_matrices) {
    expect_near(boxes(imported("{ s 2 } box"))[0].middle, {0.5, 0.5, 0.5});
    expect_near(boxes(imported("{ rz 90 } box"))[0].edge, {0, 1, 0});
    expect_near(boxes(imported("{ ry 90 } box"))[0].edge, {0, 0, -1});
    expect_near(boxes(imported("{ x 1 s 2 } box"))[0].middle, {1.5, 0.5, 0.5});
    expect_near(boxes(imported("{ s 2 x 1 } box"))[0].middle, {2.5, 0.5, 0.5});
    expect_near(boxes(imported("{ rz 90 x 1 } box"))[0].middle, {0.5, 1.5, 0.5});
    expect_near(boxes(imported("{ reflect 1 0 0 } box"))[0].middle, {-0.5, 0.5, 0.5});
    expect_near(boxes(imported("{ matrix 0 -1 0 1 0 0 0 0 1 } box"))[0].edge, {0, 1, 0});
    expect_near(boxes(imported("{ s 1/2 1 1 fx } box"))[0].edge, {-0.5, 0, 0});
}

TEST(EisenScript, loops_count_from_one_and_nest) {
    const std::vector<PlacedBox> row = boxes(imported("3 * { x 2 } box"));
    ASSERT_EQ(row.size(), 3U);
    std::vector<double> places;
    for (const PlacedBox& box : row) places.push_back(box.middle.x);
    std::ranges::sort(places);
    EXPECT_EQ(places, (std::vector<double>{2.5, 4.5, 6.5}));
    EXPECT_EQ(boxes(imported("3 * { x 2 } 4 * { y 2 } box")).size(), 12U);
}

TEST(EisenScript, depth_ends_rules_and_what_retires_them_comes_then) {
    EXPECT_EQ(boxes(imported("R rule R maxdepth 5 { { x 1 } R box }")).size(), 5U);
    EXPECT_EQ(boxes(imported("R rule R md 2 > S { 2 * { x 1 } R } rule S { box }")).size(), 4U);
    EXPECT_EQ(boxes(imported("set maxdepth 4 R rule R { { x 1 } R box }")).size(), 2U)
        << "the shape is a generation of its own";
    EXPECT_EQ(boxes(imported("R rule R md 3 > box { { x 2 } R }")).size(), 1U);
}

TEST(EisenScript, mengers_sponge_has_as_many_boxes_as_levels_say_and_few_maps) {
    std::string rule = "R rule R md 3 > S {\n";
    for (int i = 0; i < 27; ++i) {
        const int x = i % 3 - 1;
        const int y = i / 3 % 3 - 1;
        const int z = i / 9 - 1;
        if ((x == 0) + (y == 0) + (z == 0) >= 2) continue;
        rule += "{ s 1/3 x " + std::to_string(x) + " y " + std::to_string(y) + " z " +
                std::to_string(z) + " } R\n";
    }
    const Imported sponge = imported(rule + "}\nrule S { box }");
    EXPECT_THAT(sponge.text, HasSubstr("8000 shapes"));
    EXPECT_LE(sponge.scene.ifs[0].maps.size(), 3U * 20 + 1 + 1 + 8);
    EXPECT_EQ(boxes(sponge).size(), 8000U);
}

TEST(EisenScript, defines_are_put_in_and_comments_left_out) {
    const std::string text =
        "/* a\n comment */ #define no\n#define step x 2\n#define n 3 (int:1-9)\n// box\n"
        "n * { step } box // box\n";
    EXPECT_THAT(refusal(text).text, HasSubstr("'#define' is no rule of the script"));
    EXPECT_EQ(boxes(imported(text.substr(text.find("#define step")))).size(), 3U);
    EXPECT_EQ(boxes(imported("#define a 2\n{ x -a } box"))[0].middle.x, -1.5);
}

TEST(EisenScript, colours_are_steps_in_hue_saturation_and_value) {
    const auto color = [](const std::string& text) {
        const IfsBlock ifs = imported(text).scene.ifs[0];
        return *ifs.maps[ifs.maps.size() - 9].color;
    };
    EXPECT_EQ(color("box"), glm::dvec4(1, 0, 0, 1));
    EXPECT_EQ(color("{ hue 120 } box"), glm::dvec4(0, 1, 0, 1));
    EXPECT_EQ(color("{ sat 0 } box"), glm::dvec4(1, 1, 1, 1));
    EXPECT_EQ(color("{ color blue } box"), glm::dvec4(0, 0, 1, 1));
    EXPECT_EQ(color("{ color #0f0 b 0 } box"), glm::dvec4(0, 0, 0, 1));
    EXPECT_EQ(color("3 * { h 80 } box"), glm::dvec4(0, 0, 1, 1));
}

TEST(EisenScript, rules_of_one_name_are_drawn_by_weight_and_seed) {
    const std::string text = "400 * { x 2 } R rule R weight 3 { box } rule R { { y 10 } box }";
    const auto high = [&](std::uint64_t seed) {
        return std::ranges::count_if(boxes(imported(text, seed)),
                                     [](const PlacedBox& box) { return box.middle.y > 5; });
    };
    EXPECT_NEAR(static_cast<double>(high(1)), 100, 40);
    EXPECT_EQ(high(1), high(1));
    EXPECT_NE(imported(text, 1).text, imported(text, 2).text);
    EXPECT_THAT(imported(text).messages, HasSubstr("rules of one name were drawn by seed 1"));
}

TEST(EisenScript, spheres_are_objects) {
    const Imported made = imported("3 * { x 1 } sphere");
    EXPECT_TRUE(made.scene.ifs.empty());
    ASSERT_EQ(made.scene.objects.size(), 3U);
    EXPECT_EQ(made.name, "f_sphere_0");
    EXPECT_EQ(imported("3 * { x 1 } sphere box").scene.objects.size(), 4U);
    EXPECT_THAT(imported("grid box").messages, HasSubstr("grids are left out"));
}

TEST(EisenScript, what_cannot_be_taken_is_told) {
    const auto says = [](const std::string& text, const std::string& message) {
        const Refusal refused = refusal(text);
        EXPECT_EQ(refused.kind, ErrorKind::scene) << text;
        EXPECT_THAT(refused.text, HasSubstr(message)) << text;
    };
    says("", "the script places nothing");
    says("dot", "f.es:1:1: error: 'dot' is no rule of the script, and no shape that is taken");
    says("grid", "the script places no box and no sphere");
    says("{ x } box", "f.es:1:5: error: expected a number for x, found '}'");
    says("{ spin 3 } box", "f.es:1:3: error: expected a transformation or '}', found 'spin'");
    says("R rule R {", "expected '}', found the end of the file");
    says("3 box", "expected '*', found 'box'");
    says("set minsize 0.1 box", "'set minsize' is not taken: use maxdepth");
    says("{ color no } box", "expected a colour, found 'no'");
    says("R rule R md 0 { box }", "the script places no box and no sphere");
    says("#javascript\nbox", "programs in JavaScript are not run");
    says("R rule R md 1 > Q { R box }", "'Q' is no rule of the script");
    says("1000000 * { x 1 } box", "rule or shape 'box': more than 65528 maps");
    says("5000 * { x 1 } sphere", "more than 2000 spheres");
}

TEST(EisenScript, hostile_files_end_in_a_message) {
    EXPECT_EQ(refusal("R rule R md 0 > S { box } rule S md 0 > R { box }").kind, ErrorKind::scene);
    EXPECT_EQ(refusal("100000000 * { x 1 } 100000000 * { x 1 } box").kind, ErrorKind::scene);
    EXPECT_EQ(refusal("{ x 1e999 } box").kind, ErrorKind::scene);
    EXPECT_EQ(refusal("900 * { s 1e300 } box").kind, ErrorKind::scene);
    EXPECT_EQ(refusal("{ x nan } box").kind, ErrorKind::scene);
    EXPECT_EQ(refusal(std::string(100'000, '{')).kind, ErrorKind::scene);
    EXPECT_EQ(refusal("\x01 \x80 box").kind, ErrorKind::scene);
}

TEST(EisenScript, a_file_cut_anywhere_is_a_scene_or_one_message) {
    const std::string whole =
        "set maxdepth 9 /* c */ set background #fff\n3 * { x 1 ry 1/2 hue 3 blend #f00 0.1 } R\n"
        "rule R w 2 md 3 > S { { s 0.5 } R { s 1 2 3 } box::shiny sphere }\nrule S { box }\n";
    for (std::size_t end = 0; end <= whole.size(); ++end) {
        const Refusal refused = refusal(whole.substr(0, end));
        EXPECT_TRUE(!refused.kind || refused.kind == ErrorKind::scene) << end << refused.text;
    }
}

TEST(EisenScript, any_bytes_end_in_a_scene_or_a_message) {
    const std::string alphabet = "{}*>/# \nxyzsrRSbox0123456789.-+[]\x80\x01";
    const std::string whole = "4 * { x 1 } R\nrule R md 3 > S { { s 0.5 } R }\nrule S { box }\n";
    for (unsigned seed = 0; seed < 1000; ++seed) {
        std::mt19937 random(seed);
        std::string text = whole;
        for (int i = 0; i < 3; ++i)
            text[random() % text.size()] = alphabet[random() % alphabet.size()];
        const Refusal refused = refusal(text);
        EXPECT_TRUE(!refused.kind || refused.kind == ErrorKind::scene) << text << refused.text;
    }
}

}  // namespace
}  // namespace pxm::host
