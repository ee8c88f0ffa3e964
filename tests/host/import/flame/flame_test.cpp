// Flames: what comes out of a .flame file is what flam3 makes of it, as far as it is linear.
#include "host/import/flame/flame.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <random>
#include <string>
#include <variant>
#include <vector>

#include "host/error.hpp"
#include "host/import/import.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {
namespace {

using testing::HasSubstr;

Imported imported(const std::string& text, const FlameRequest& request = {}) {
    return import_flame({"f.flame", text}, request);
}

struct Refusal {
    std::optional<ErrorKind> kind;
    std::string text;
};

Refusal refusal(const std::string& text, const FlameRequest& request = {}) {
    try {
        (void)imported(text, request);
        return {};
    } catch (const Error& error) {
        return {error.kind(), error.what()};
    }
}

std::string flame(const std::string& inside, const std::string& attributes = "") {
    return "<flame name=\"f\" size=\"640 480\" scale=\"100\" " + attributes + ">\n" + inside +
           "</flame>\n";
}

std::string xform(const std::string& coefs, const std::string& more = "") {
    return "<xform weight=\"1\" linear=\"1\" coefs=\"" + coefs + "\" " + more + "/>\n";
}

const std::string gasket =
    flame(xform("0.5 0 0 0.5 0 0") + xform("0.5 0 0 0.5 0.5 0") + xform("0.5 0 0 0.5 0 0.5"));

Affine map_of(const Imported& made, std::size_t i) {
    return compose(made.scene.ifs[0].maps[i].commands);
}

/// The names of the maps that may stand inside one.
std::vector<std::string> inside(const Imported& made, const std::string& name) {
    std::vector<std::string> names;
    for (const FollowRule& rule : made.scene.ifs[0].follow)
        if (std::get<std::string>(rule.map.map) == name)
            for (const MapReference& follower : rule.followers)
                names.push_back(std::get<std::string>(follower.map));
    return names;
}

/// flam3's own game, by its rules and nothing else: points after transforms that are drawn by
/// weight, times the chaos of the one before; y as in the file.
struct Transform {
    double coefs[6] = {1, 0, 0, 1, 0, 0};
    double post[6] = {1, 0, 0, 1, 0, 0};
    double linear = 1;
    double weight = 1;
    std::vector<double> chaos;
    double opacity = 1;
};
std::vector<glm::dvec2> chaos_game(const std::vector<Transform>& transforms, int count) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<glm::dvec2> points;
    glm::dvec2 p{0.1, 0.2};
    std::size_t before = 0;
    const auto apply = [](const double(&c)[6], glm::dvec2 q) {
        return glm::dvec2{c[0] * q.x + c[2] * q.y + c[4], c[1] * q.x + c[3] * q.y + c[5]};
    };
    for (int i = -50; i < count; ++i) {
        std::vector<double> shares;
        for (std::size_t t = 0; t < transforms.size(); ++t) {
            const std::vector<double>& chaos = transforms[before].chaos;
            shares.push_back(transforms[t].weight * (t < chaos.size() ? chaos[t] : 1));
        }
        before = std::discrete_distribution<std::size_t>(shares.begin(), shares.end())(random);
        const Transform& t = transforms[before];
        p = apply(t.post, t.linear * apply(t.coefs, p));
        if (i >= 0 && t.opacity > 0) points.push_back(p);
    }
    return points;
}

/// True if the point lies in the set of the scene's maps, up to `error`: words are followed whose
/// images of a ball of radius 10 hold the point.
bool is_near(const Imported& made, const glm::dvec2& flame_point, double error) {
    const IfsBlock& ifs = made.scene.ifs[0];
    const glm::dvec3 point{flame_point.x, -flame_point.y, 0};
    const auto names = [&] {
        std::vector<std::string> all;
        for (const MapBlock& map : ifs.maps) all.push_back(map.name);
        return all;
    }();
    const auto number = [&](const std::string& name) {
        return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
    };
    const std::function<bool(const Affine&, double, const std::vector<std::string>&)> search =
        [&](const Affine& word, double radius, const std::vector<std::string>& next) {
            const glm::dvec3 gap = word.point({0, 0, 0}) - point;
            if (std::sqrt(gap.x * gap.x + gap.y * gap.y) > radius + error) return false;
            if (radius < error) return true;
            for (const std::string& name : next) {
                const Affine map = compose(ifs.maps[number(name)].commands);
                const Affine longer = then(map, word);
                const double stretch =
                    std::max({std::abs(longer.linear[0].x) + std::abs(longer.linear[1].x),
                              std::abs(longer.linear[0].y) + std::abs(longer.linear[1].y)});
                const std::vector<std::string> follow = inside(made, name);
                if (search(longer, 10 * 1.5 * stretch, follow.empty() ? names : follow))
                    return true;
            }
            return false;
        };
    std::vector<std::string> start;
    for (const MapReference& reference : ifs.start)
        start.push_back(std::get<std::string>(reference.map));
    return search(Affine{}, 1e9, start.empty() ? names : start);
}

TEST(Flame, coefs_stand_by_columns_and_y_is_turned_up) {
    const Imported made = imported(flame(xform("0.1 0.2 0.3 0.4 0.5 0.6")));
    const Affine map = map_of(made, 0);
    // x' = 0.1 x + 0.3 y + 0.5, y' = 0.2 x + 0.4 y + 0.6 in the file
    const glm::dvec3 image = map.point({2, -3, 0});
    EXPECT_NEAR(image.x, 0.1 * 2 + 0.3 * 3 + 0.5, 1e-12);
    EXPECT_NEAR(image.y, -(0.2 * 2 + 0.4 * 3 + 0.6), 1e-12);
}

TEST(Flame, linear_is_a_factor_and_post_comes_after_it) {
    const Imported made = imported(flame(
        "<xform weight=\"1\" linear=\"0.5\" coefs=\"1 0 0 1 1 0\" post=\"0.5 0 0 0.5 0 3\"/>"));
    const glm::dvec3 image = map_of(made, 0).point({0, 0, 0});
    EXPECT_NEAR(image.x, 0.5 * 0.5, 1e-12);
    EXPECT_NEAR(image.y, -3, 1e-12);
}

TEST(Flame, points_of_flam3s_game_lie_in_the_scene) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int round = 0; round < 10; ++round) {
        std::vector<Transform> transforms(3);
        std::string text;
        for (Transform& t : transforms) {
            for (double& c : t.coefs) c = std::round(500 * unit(random)) / 1000;
            t.linear = 0.9;
            if (round % 2 == 1) t.post[4] = 0.25;
            for (int k = 0; k < 3; ++k)
                t.chaos.push_back(round < 5 ? 1.0 : static_cast<double>(random() % 3));
            t.chaos[static_cast<std::size_t>(&t - transforms.data() + 1) % 3] = 1;
            text += "<xform weight=\"1\" linear=\"0.9\" coefs=\"";
            for (const double c : t.coefs) text += std::to_string(c) + ' ';
            text += "\" post=\"1 0 0 1 " + std::to_string(t.post[4]) + " 0\" chaos=\"";
            for (const double c : t.chaos) text += std::to_string(c) + ' ';
            text += "\"/>\n";
        }
        SCOPED_TRACE(text);
        const Imported made = imported(flame(text));
        for (const glm::dvec2& p : chaos_game(transforms, 100))
            ASSERT_TRUE(is_near(made, p, 1e-4)) << p.x << ' ' << p.y;
    }
}

TEST(Flame, what_may_come_after_a_transform_is_what_it_may_stand_inside_of) {
    // After the first only the second, after the second both: never the first after itself.
    const Imported made = imported(flame(xform("0.4 0 0 0.4 0 0", "chaos=\"0 1\"") +
                                         xform("0.4 0 0 0.4 1 0", "chaos=\"1 1\"")));
    EXPECT_THAT(inside(made, "xform_1"), testing::ElementsAre("xform_2"));
    EXPECT_THAT(inside(made, "xform_2"), testing::ElementsAre("xform_1", "xform_2"));
}

TEST(Flame, a_transform_that_comes_after_none_is_left_out) {
    const Imported made = imported(flame(xform("0.4 0 0 0.4 0 0", "chaos=\"0 1 1\"") +
                                         xform("0.4 0 0 0.4 1 0", "chaos=\"0 1 1\"") +
                                         xform("0.4 0 0 0.4 0 1", "chaos=\"0 1 0.5\"")));
    ASSERT_EQ(made.scene.ifs[0].maps.size(), 2U);
    EXPECT_EQ(made.scene.ifs[0].maps[0].name, "xform_2");
    EXPECT_THAT(
        refusal(flame(xform("0.4 0 0 0.4 0 0", "chaos=\"0 0\"") + xform("0.4 0 0 0.4 1 0"))).text,
        HasSubstr("xform 1: its chaos lets nothing come after it"));
}

TEST(Flame, transforms_without_opacity_go_on_but_are_no_outermost_maps) {
    const Imported made =
        imported(flame(xform("0.4 0 0 0.4 0 0", "opacity=\"0\"") +
                       xform("0.4 0 0 0.4 1 0", "plotmode=\"off\"") + xform("0.4 0 0 0.4 0 1")));
    ASSERT_EQ(made.scene.ifs[0].start.size(), 1U);
    EXPECT_EQ(std::get<std::string>(made.scene.ifs[0].start[0].map), "xform_3");
    EXPECT_EQ(made.scene.ifs[0].maps.size(), 3U);
}

TEST(Flame, a_transform_without_weight_never_comes) {
    const Imported made =
        imported(flame(xform("0.4 0 0 0.4 0 0") + "<xform linear=\"1\" coefs=\"2 0 0 2 0 0\"/>"));
    EXPECT_EQ(made.scene.ifs[0].maps.size(), 1U);
    EXPECT_EQ(refusal(flame("<xform linear=\"1\"/>")).kind, ErrorKind::scene);
}

TEST(Flame, the_final_transform_places_the_object) {
    const std::string final_ =
        "<finalxform linear=\"1\" coefs=\"2 0 0 2 0 1\" opacity=\"OPACITY\"/>";
    const auto with = [&](const std::string& opacity) {
        std::string text = final_;
        text.replace(text.find("OPACITY"), 7, opacity);
        return imported(flame(xform("0.5 0 0 0.5 0 0") + xform("0.5 0 0 0.5 1 0") + text)).scene;
    };
    ASSERT_EQ(with("1").objects.size(), 1U);
    const glm::dvec3 moved = compose(with("1").objects[0].commands).point({1, 1, 0});
    EXPECT_EQ(moved.x, 2);
    EXPECT_EQ(moved.y, 1);
    EXPECT_EQ(with("0.5").objects.size(), 2U);
    EXPECT_EQ(with("0").objects.size(), 0U);
}

TEST(Flame, symmetry_takes_every_map_once_a_turn) {
    const Imported three = imported(flame(xform("0.3 0 0 0.3 0.5 0") + "<symmetry kind=\"3\"/>"));
    ASSERT_EQ(three.scene.ifs[0].maps.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 p = map_of(three, i).point({0, 0, 0});
        EXPECT_NEAR(p.x * p.x + p.y * p.y, 0.25, 1e-12);
    }
    EXPECT_EQ(imported(flame(xform("0.3 0 0 0.3 0.5 0") + "<symmetry kind=\"-3\"/>"))
                  .scene.ifs[0]
                  .maps.size(),
              6U);
    EXPECT_EQ(imported(flame(xform("0.3 0 0 0.3 0.5 0") + "<symmetry kind=\"1\"/>"))
                  .scene.ifs[0]
                  .maps.size(),
              1U);
}

TEST(Flame, its_view_is_the_files) {
    const Imported made = imported(flame(xform("0.5 0 0 0.5 0 0") + xform("0.5 0 0 0.5 1 0"),
                                         "center=\"1 2\" zoom=\"1\" rotate=\"90\""));
    const CameraBlock& camera = *made.scene.camera;
    EXPECT_EQ((*camera.look)[0].value, 1);
    EXPECT_EQ((*camera.look)[1].value, -2);
    EXPECT_EQ(*camera.orthographic, 640 / 200.0);
    EXPECT_NEAR(camera.up->x, -1, 1e-12);
    EXPECT_EQ(made.scene.image->size->columns, 640);
}

TEST(Flame, palettes_have_three_forms) {
    std::string hex;
    for (int i = 0; i < 256; ++i) hex += i < 128 ? "FF0000" : "0000FF";
    const auto color = [&](const std::string& palette) {
        return imported(
                   flame(xform("0.5 0 0 0.5 0 0", "color=\"0.9\" color_speed=\"0.25\"") + palette))
            .scene.ifs[0]
            .maps[0]
            .color;
    };
    const glm::dvec4 blue{0, 0, 1, 0.25};
    EXPECT_EQ(color("<palette count=\"256\" format=\"RGB\">" + hex + "</palette>"), blue);
    std::string wide;
    for (int i = 0; i < 256; ++i) wide += i < 128 ? "00FF0000" : "000000FF";
    EXPECT_EQ(color("<colors count=\"256\" data=\"" + wide + "\"/>"), blue);
    EXPECT_EQ(color("<color index=\"0\" rgb=\"255 0 0\"/><color index=\"200\" rgb=\"0 0 255\"/>"
                    "<color index=\"255\" rgb=\"0 0 255\"/>"),
              blue);
    EXPECT_EQ(color(""), std::nullopt);
    EXPECT_THAT(refusal(flame(xform("0.5 0 0 0.5 0 0") + "<palette>FF00</palette>")).text,
                HasSubstr("palette: expected up to 256 colours of 6 digits, found 4 digits"));
}

TEST(Flame, other_variations_are_refused_by_name) {
    const std::string text =
        flame(xform("0.5 0 0 0.5 0 0", "julian=\"0.3\" julian_power=\"2\" bubble=\"0\""));
    const Refusal refused = refusal(text);
    EXPECT_EQ(refused.kind, ErrorKind::scene);
    EXPECT_THAT(refused.text,
                HasSubstr("f.flame:2:1: error: xform 1: not linear: julian (--affine-part leaves "
                          "out all but 'linear')"));
    const Imported taken = imported(text, {std::nullopt, Variations::affine_part});
    EXPECT_THAT(taken.messages, HasSubstr("xform 1: julian left out\n"));
    EXPECT_EQ(refusal(flame("<xform weight=\"1\" spherical=\"1\" coefs=\"1 0 0 1 0 0\"/>"),
                      {std::nullopt, Variations::affine_part})
                  .kind,
              ErrorKind::scene);
}

TEST(Flame, one_of_several_is_chosen_by_name_or_place) {
    const std::string two =
        "<flames>" + gasket + "<flame>" + xform("0.5 0 0 0.5 0 0") + "</flame></flames>";
    EXPECT_EQ(refusal(two).text,
              "f.flame has 2 entries; choose one with --entry NAME:\n  f\n  flame 2");
    EXPECT_EQ(imported(two, {"flame 2", {}}).scene.ifs[0].maps.size(), 1U);
    EXPECT_EQ(imported(two, {"#1", {}}).scene.ifs[0].maps.size(), 3U);
    EXPECT_EQ(refusal(two, {"#3", {}}).kind, ErrorKind::setting);
}

TEST(Flame, numbers_that_are_none_are_told_at_their_element) {
    for (const char* bad : {"0.5 0 0 0.5 0", "nan 0 0 0.5 0 0", "1e999 0 0 0.5 0 0",
                            "0,5 0 0 0,5 0 0", "0.5 0 0 0.5 0 0 1", "\x01 0 0 0.5 0 0"})
        EXPECT_THAT(refusal(flame(xform(bad))).text,
                    HasSubstr("f.flame:2:1: error: xform 1: coefs="))
            << bad;
}

TEST(Flame, a_file_cut_anywhere_is_a_scene_or_one_message) {
    const std::string whole =
        "<?xml version=\"1.0\"?>\n<flames name=\"x\">\n" + gasket + "<!-- a comment --></flames>";
    for (std::size_t end = 0; end < whole.size(); ++end) {
        const Refusal refused = refusal(whole.substr(0, end));
        EXPECT_TRUE(!refused.kind || refused.kind == ErrorKind::scene) << end << refused.text;
    }
}

TEST(Flame, hostile_files_end_in_a_message) {
    std::string nested;
    for (int i = 0; i < 200'000; ++i) nested += "<a>";
    EXPECT_EQ(refusal(nested).kind, ErrorKind::scene);
    EXPECT_EQ(refusal(nested + gasket).kind, ErrorKind::scene);
    const std::string laughs = "<!DOCTYPE f [<!ENTITY a \"aaaa\"><!ENTITY b \"&a;&a;\">]>\n" +
                               flame(xform("&b; 0 0 0.5 0 0"));
    EXPECT_THAT(refusal(laughs).text, HasSubstr("xform 1: coefs=\"&b; 0 0 0.5 0 0\""));
    EXPECT_EQ(refusal(std::string(5'000'000, '<')).kind, ErrorKind::scene);
    EXPECT_EQ(refusal("").kind, ErrorKind::scene);
    EXPECT_EQ(refusal(flame(xform("1 0 0 1 0 0"))).kind, ErrorKind::scene);
}

TEST(Flame, any_bytes_end_in_a_scene_or_a_message) {
    const std::string alphabet = "<>=\"'/ &;#x0123456789.-eNa\n\t\x80\xff";
    for (unsigned seed = 0; seed < 500; ++seed) {
        std::mt19937 random(seed);
        std::string text = gasket;
        for (int i = 0; i < 5; ++i)
            text[random() % text.size()] = alphabet[random() % alphabet.size()];
        const Refusal refused = refusal(text);
        EXPECT_TRUE(!refused.kind || refused.kind == ErrorKind::scene ||
                    refused.kind == ErrorKind::setting)
            << text << refused.text;
    }
}

}  // namespace
}  // namespace pxm::host
