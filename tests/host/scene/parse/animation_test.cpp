// Laws of time in a scene: t, frame, key(...), blend, and the block that they belong to.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "host/scene/check/check.hpp"
#include "host/scene/parse/keys.hpp"
#include "host/scene/parse/parser.hpp"
#include "host/scene/print/print.hpp"

namespace pxm::host {
namespace {

constexpr const char* film = "animation { frames: 11 }\n";
constexpr const char* half = "ifs a { newmap scale: 0.5 }\n";

/// A text of a scene, read at a frame.
struct Read {
    Scene scene;
    std::string mistakes;
};
Read read(const std::string& text, double frame = 0) {
    Diagnostics diagnostics;
    Read result;
    result.scene = parse_text("s.pxm", text, diagnostics, nullptr, nullptr, frame);
    if (!diagnostics.has_errors()) check_scene(result.scene, diagnostics);
    result.mistakes = diagnostics.text(result.scene.files);
    return result;
}

/// The number that an expression has at a frame of eleven.
double at(const std::string& expression, double frame) {
    const Read r = read(film + std::string(half) + "camera { fov: " + expression + " }", frame);
    EXPECT_EQ(r.mistakes, "") << expression;
    return r.scene.camera ? r.scene.camera->fov.value_or(0) : 0;
}

/// The first line of what is wrong.
std::string mistake(const std::string& text) {
    const std::string all = read(text).mistakes;
    return all.substr(0, all.find('\n'));
}

TEST(Time, runs_from_0_to_1_over_the_frames) {
    EXPECT_EQ(at("1 + t", 0), 1);
    EXPECT_EQ(at("1 + t", 5), 1.5);
    EXPECT_EQ(at("1 + t", 10), 2);
    EXPECT_EQ(at("1 + frame", 10), 11);
    EXPECT_EQ(at("1 + t", 2.5), 1.25);
    EXPECT_EQ(read("animation { frames: 1 }" + std::string(half) + "camera { fov: 1 + t }", 0)
                  .scene.camera->fov,
              1);
}

TEST(Time, is_known_after_an_animation_only_and_takes_no_name_away) {
    EXPECT_EQ(mistake(std::string(half) + "camera { fov: 30 * t }"),
              "s.pxm:2:20: error: expected a number, found 't', which is known after an "
              "'animation' only");
    EXPECT_EQ(read("let t = 3 let key = 2 let rate = 7 ifs zoom { newmap blend scale: 1/t }\n"
                   "light key { direction: 0,key,rate }")
                  .mistakes,
              "");
    // A name of before wins.
    EXPECT_EQ(
        read("let t = 3" + std::string(film) + half + "camera { fov: t }", 5).scene.camera->fov, 3);
}

TEST(Keys, are_met_and_held_outside) {
    const std::string keys = "key(frame: 2 -> 10, 4 -> 20, 8 -> 5)";
    for (const char* kind : {"", ", smooth", ", linear", ", stepped", ", exponential"}) {
        const std::string text = "key(frame: 2 -> 10, 4 -> 20, 8 -> 5" + std::string(kind) + ")";
        EXPECT_NEAR(at(text, 0), 10, 1e-12) << kind;
        EXPECT_NEAR(at(text, 2), 10, 1e-12) << kind;
        EXPECT_NEAR(at(text, 4), 20, 1e-12) << kind;
        EXPECT_NEAR(at(text, 8), 5, 1e-12) << kind;
        EXPECT_NEAR(at(text, 10), 5, 1e-12) << kind;
    }
    EXPECT_EQ(at("key(frame: 2 -> 10, 4 -> 20, linear)", 3), 15);
    EXPECT_EQ(at("key(frame: 2 -> 10, 4 -> 20, stepped)", 3.9), 10);
    EXPECT_NEAR(at("key(frame: 2 -> 1, 4 -> 100, exponential)", 3), 10, 1e-12);
    EXPECT_EQ(at("key(t: 0 -> 1, 1 -> 3) * 2 + key(t: 0 -> 1, 1 -> 2)", 10), 8);
}

TEST(Keys, smooth_ones_rest_at_their_ends_and_never_overshoot) {
    const std::vector<Key> keys{{0, 1}, {1, 5}, {1.5, 5.5}, {4, 2}, {5, 2}};
    const auto value = [&](double x) { return value_between(keys, x, Interpolation::smooth); };
    constexpr double step = 1e-4;
    for (const double end : {0.0, 5.0}) {
        const double slope = (value(end + step) - value(end - step)) / (2 * step);
        EXPECT_NEAR(slope, 0, 1e-2);
    }
    for (double x = 0; x < 5; x += step) {
        const auto after = std::ranges::find_if(keys, [&](const Key& k) { return k.at > x; });
        const double a = (after - 1)->value, b = after->value;
        EXPECT_GE(value(x), std::min(a, b) - 1e-12);
        EXPECT_LE(value(x), std::max(a, b) + 1e-12);
        // No corner: the slope does not jump.
        const double slope = (value(x + step) - value(x)) / step;
        const double before = (value(x) - value(x - step)) / step;
        EXPECT_LT(std::abs(slope - before), 0.01) << x;
    }
}

TEST(Keys, may_be_points_and_colors) {
    const std::string text =
        std::string(film) + half +
        "camera { eye: key(t: 0 -> (0,0,-4), 1 -> (2,4,-2), linear) look: 0,1,0 }\n"
        "light { direction: 1,key(t: 0 -> (1+1)*2, 1 -> 8, linear),0 }\n"
        "object o { ifs: a color: key(t: 0 -> (0,0,0,1), 1 -> (1,1,0,0)) }";
    const Read r = read(text, 5);
    ASSERT_EQ(r.mistakes, "");
    EXPECT_EQ((*r.scene.camera->eye)[0].value, 1);
    EXPECT_EQ((*r.scene.camera->eye)[2].value, -3);
    EXPECT_EQ(*r.scene.lights[0].direction, (glm::dvec3{1, 6, 0}));
    EXPECT_EQ(*r.scene.objects[0].color, (glm::dvec4{0.5, 0.5, 0, 0.5}));
}

/// Also where it takes one as well.
TEST(Keys, may_be_points_for_scale_as_for_every_directive_of_several_numbers) {
    const std::string text =
        std::string(film) +
        "ifs a { newmap scale: key(t: 0 -> (0.5,0.25,0.5), 1 -> (0.25,0.75,0.5), linear) }\n"
        "object o { ifs: a scale: key(t: 0 -> (1,2,3), 1 -> (3,4,5), linear) }\n"
        "object p { ifs: a scale: key(t: 0 -> (1+1)*1, 1 -> 4, linear) }\n"
        "render { covers: key(t: 0 -> (0.25,1), 1 -> (0.75,3), linear) }";
    const Read r = read(text, 5);
    ASSERT_EQ(r.mistakes, "");
    EXPECT_EQ(compose(r.scene.ifs[0].maps[0].commands), scaling({0.375, 0.5, 0.5}));
    EXPECT_EQ(compose(r.scene.objects[0].commands), scaling({2, 3, 4}));
    EXPECT_EQ(compose(r.scene.objects[1].commands), scaling({3, 3, 3}));
    EXPECT_EQ(std::get<Covers>(*r.scene.render->covers), (Covers{0.5, 2}));
}

TEST(Zoom, goes_exponentially_by_its_keys) {
    const std::string text =
        std::string(film) + half + "camera { zoom: key(t: 0 -> 1, 1 -> 1e30) }";
    EXPECT_NEAR(*read(text, 5).scene.camera->zoom / 1e15, 1, 1e-9);
    // What is computed of keys is as everywhere.
    const std::string twice =
        std::string(film) + half + "camera { zoom: key(t: 0 -> 1, 1 -> 3, linear) * 2 }";
    EXPECT_NEAR(*read(twice, 5).scene.camera->zoom, 4, 1e-9);
    EXPECT_EQ(mistake(std::string(film) + half + "camera { zoom: key(t: 0 -> 0, 1 -> 9) }"),
              "s.pxm:3:28: error: a value that goes exponentially is greater than 0");
}

TEST(Keys, mistakes_are_told_where_they_are) {
    const auto of = [](const std::string& key) {
        return mistake(film + std::string(half) + "camera { fov: " + key + " }");
    };
    EXPECT_EQ(of("key(t: 0 -> 1, 0.5 -> 2, 0.4 -> 3)"),
              "s.pxm:3:40: error: the keys are out of order: 0.4 comes after 0.5");
    EXPECT_EQ(of("key(t: 0 -> 1, 0 -> 2)"),
              "s.pxm:3:30: error: the keys are out of order: 0 comes after 0");
    EXPECT_EQ(of("key(t: 0 -> 1, 1 -> 2, square)"),
              "s.pxm:3:38: error: expected smooth, linear, stepped or exponential, found 'square'");
    EXPECT_EQ(of("key(t, 0 -> 1)").substr(0, 33), "s.pxm:3:20: error: expected ':', ");
    EXPECT_EQ(of("key(t: 0 1)").substr(0, 34), "s.pxm:3:24: error: expected '->', ");
    std::string deep;
    for (int i = 0; i < 300; ++i) deep += "key(t: 0 -> ";
    EXPECT_NE(of(deep).find("nested deeper than 200"), std::string::npos);
}

constexpr const char* blend =
    "ifs ends { newmap low scale: 0.5 newmap scale: 0.5 rotate: y,90 translate: 1,0,0 }\n";

TEST(Blends, are_maps_between_maps_by_name_and_by_number) {
    const Read r = read(film + std::string(blend) +
                            "ifs a { newmap blend: ends low -> ends 2, t\n"
                            "newmap blend: 1 -> ends 2, 1 newmap scale: 0.25 }",
                        5);
    ASSERT_EQ(r.mistakes, "");
    const Affine middle = compose(r.scene.ifs[1].maps[0].commands);
    const Affine expected =
        then(then(scaling(glm::dvec3{0.5}), rotation(Axis::y, 45)), translation({0.5, 0, 0}));
    EXPECT_NEAR(glm::length(middle.linear[0] - expected.linear[0]), 0, 1e-12);
    EXPECT_NEAR(glm::length(middle.translation - expected.translation), 0, 1e-12);
    const Affine last = compose(r.scene.ifs[1].maps[1].commands);
    EXPECT_EQ(last, compose(r.scene.ifs[0].maps[1].commands));
    Diagnostics diagnostics;
    EXPECT_EQ(parse_text("again", print_scene(r.scene), diagnostics, nullptr, nullptr, 5), r.scene);
}

TEST(Blends, mistakes_are_told_where_they_are) {
    const auto of = [](const std::string& maps) {
        return mistake(std::string(film) + blend + "ifs a { newmap " + maps +
                       " newmap scale: 0.5 }");
    };
    EXPECT_EQ(of("blend: other 1 -> ends 2, t"),
              "s.pxm:3:29: error: blend: there is no ifs \"other\"");
    EXPECT_EQ(of("blend: ends 3 -> ends 2, t"),
              "s.pxm:3:28: error: blend: ifs \"ends\" has no such map");
    EXPECT_EQ(of("blend: 1 -> ends 2, t"), "s.pxm:3:9: error: the map is a blend of itself");
    EXPECT_EQ(of("scale: -1,1,1 newmap blend: 1 -> ends 2, t").substr(0, 50),
              "s.pxm:3:37: error: blend: one of the maps mirrors ");
    EXPECT_EQ(of("blend: ends low, t").substr(0, 46),
              "s.pxm:3:31: error: expected '->', found ',' (b");
}

TEST(Animation, has_its_ranges) {
    const auto of = [](const std::string& values) {
        return mistake("animation { " + values + " }\n" + half);
    };
    EXPECT_EQ(of("frames: 24 rate: 30 shutter: 0.5"), "");
    EXPECT_NE(of("frames: 0"), "");
    EXPECT_NE(of("frames: 1000001"), "");
    EXPECT_NE(of("frames: 2 rate: 0"), "");
    EXPECT_NE(of("frames: 2 shutter: 1.5"), "");
    EXPECT_NE(mistake(film + std::string(film) + half), "");
}

}  // namespace
}  // namespace pxm::host
