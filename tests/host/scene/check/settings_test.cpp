// Laws of host/scene/check/settings: a scene with something set of it is the scene that says so
// itself.
#include "host/scene/check/settings.hpp"

#include <gtest/gtest.h>

#include "host/error.hpp"
#include "tests/host/scene/scene_text.hpp"
#include "tests/support/folder.hpp"

namespace pxm::host {
namespace {

const char* const orchard =
    "let half = 1/2\n"
    "let height = sqrt(half)\n"
    "ifs tree { newmap stem scale: half translate: 0,height,0\n"
    "           newmap scale: 0.3 weight: 2 start: stem }\n"
    "ifs bush { newmap scale: 0.4 }\n"
    "texture boards { wood size: 2,1 }\n"
    "texture grain { wood }\n"
    "plane { normal: 0,1,0 texture: boards }\n"
    "light sun { direction: 0,1,0 }\n"
    "light { position: 1,2,-3 }\n"
    "camera { eye: 0,0,-5 look: 0,0,0 }\n"
    "object a { ifs: tree box: (-2,-2,-2)(2,2,2) levels: 4 scale: half }\n"
    "object b { ifs: bush }\n";

/// The scene of a text with settings; the message if one of them is refused.
class Set : public testing::Test {
  protected:
    [[nodiscard]] Scene with(const std::string& text, const std::vector<std::string>& set) const {
        folder.write("s.pxm", text);
        Diagnostics diagnostics;
        Scene scene = parse_scene(folder.path("s.pxm"), parse_settings(set), diagnostics);
        diagnostics.throw_if_errors(scene.files);
        return scene;
    }
    void expect_refused(const std::vector<std::string>& set, const std::string& why) const {
        try {
            (void)with(orchard, set);
            ADD_FAILURE() << set.back() << " is taken";
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::setting);
            EXPECT_EQ(error.what(), "--set " + set.back() + ": " + why);
        }
    }
    /// What is set has the same effect as another text.
    void expect_same(const std::vector<std::string>& set, const std::string& in_place_of,
                     const std::string& written) const {
        std::string text = orchard;
        const std::size_t at = text.find(in_place_of);
        ASSERT_NE(at, std::string::npos) << in_place_of;
        text.replace(at, in_place_of.size(), written);
        EXPECT_TRUE(with(orchard, set) == test::parsed(text)) << set.back();
        EXPECT_FALSE(test::parsed(orchard) == test::parsed(text)) << written;
    }
    test::Folder folder;
};

TEST_F(Set, a_let_is_another_number_for_all_that_comes_after_it) {
    expect_same({"half=0.25"}, "half = 1/2", "half = 0.25");
    expect_same({"half = 1/3 + sin(30)/100"}, "half = 1/2", "half = 1/3 + sin(30)/100");
    expect_same({"height=2*half"}, "sqrt(half)", "2*half");
    expect_same({"half=7", "half=1/3"}, "half = 1/2", "half = 1/3");
    EXPECT_TRUE(with(orchard, {"half=0.5"}) == test::parsed(orchard));
}

TEST_F(Set, a_let_of_an_included_file_too) {
    folder.write("part.pxm", "let side = 0.5\nifs a { newmap scale: side }\n");
    const Scene scene = with("include: \"part.pxm\"\n", {"side=0.25"});
    EXPECT_TRUE(scene == test::parsed("ifs a { newmap scale: 0.25 }"));
}

TEST_F(Set, a_value_of_a_block_is_what_its_directive_would_say) {
    expect_same({"object.a.levels=9"}, "levels: 4", "levels: 9");
    expect_same({"object.2.color=1,0,0,half"}, "ifs: bush }", "ifs: bush color: 1,0,0,half }");
    expect_same({"object.a.sphere=(0,0,0) 4"}, "box: (-2,-2,-2)(2,2,2)", "sphere: (0,0,0) 4");
    expect_same({"object.b.ifs=tree"}, "ifs: bush }", "ifs: tree }");
    expect_same({"texture.boards.size=3,half"}, "2,1", "3,half");
    expect_same({"plane.texture=grain, boards"}, "texture: boards", "texture: grain, boards");
    expect_same({"light.sun.shadow=on"}, "0,1,0 }\nlight", "0,1,0 shadow: on }\nlight");
    expect_same({"light.2.position=0,9,0"}, "1,2,-3", "0,9,0");
    expect_same({"camera.fov=60*half"}, "eye:", "fov: 30 eye:");
    expect_same({"ifs.tree.stem.color=0,1,0,1"}, "height,0\n", "height,0 color: 0,1,0,1\n");
    expect_same({"ifs.tree.2.weight=5"}, "weight: 2", "weight: 5");
    expect_same({"ifs.tree.start=2"}, "start: stem", "start: 2");
}

TEST_F(Set, a_block_that_a_scene_has_once_need_not_be_there) {
    expect_same({"image.size=32,24"}, "object b", "image { size: 32,24 } object b");
    expect_same({"render.shading=low-pass", "render.covers=area"}, "object b",
                "render { shading: low-pass covers: area } object b");
    const std::string text = "ifs tree { newmap scale: 0.5 }\n";
    const Scene scene = with(text, {"object.tree.levels=3"});
    ASSERT_EQ(scene.objects.size(), 1U);
    EXPECT_EQ(scene.objects[0].levels, 3);
}

TEST_F(Set, settings_may_be_right_only_together) {
    const Scene scene = with(orchard, {"camera.look=0,0,-5", "camera.eye=0,0,-9"});
    EXPECT_EQ((*scene.camera->look)[2].value, -5);
    expect_refused({"camera.eye=0,0,0"}, "camera: 'eye' and 'look' are the same point");
}

TEST_F(Set, the_digits_of_an_eye_are_kept) {
    const std::string digits = "-0.123456789012345678901234567890";
    const Scene scene = with(orchard, {"camera.eye=" + digits + ",0,-5"});
    EXPECT_EQ((*scene.camera->eye)[0].text, digits);
}

TEST_F(Set, what_is_not_there_is_told_with_what_is) {
    expect_refused({"haf=1"}, "the scene has no 'let' of that name (it has half, height)");
    expect_refused({"camra.fov=30"}, "there is no kind of block 'camra' (did you mean 'camera'?)");
    expect_refused({"x.fov=30"},
                   "there is no kind of block 'x' (ifs, object, plane, texture, light, camera, "
                   "image, render, animation)");
    expect_refused({"camera.fvo=30"}, "unknown directive 'fvo' in 'camera' (did you mean 'fov'?)");
    expect_refused({"image.x=30"}, "unknown directive 'x' in 'image' (it takes size, crop)");
    expect_refused({"object.c.levels=3"}, "the scene has no object \"c\" (it has a, b)");
    expect_refused({"light.moon.color=1,1,1"}, "the scene has no light \"moon\" (it has sun, 2)");
    expect_refused({"object.levels=3"},
                   "the scene has 2 of kind 'object': say object.NAME.levels (of a, b)");
    expect_refused({"ifs.tree.leaf.color=1,0,0,1"},
                   "ifs \"tree\" has no map \"leaf\" (it has stem, 2)");
    expect_refused({"object.b.ifs=fern"}, "there is no ifs \"fern\"");
}

TEST_F(Set, a_value_is_read_by_the_rules_of_its_directive) {
    expect_refused({"camera.fov=x"}, "expected a number, found 'x', which no 'let' has named");
    expect_refused({"half=1+"}, "expected a number, found nothing more");
    expect_refused({"half=1,2"}, "expected one expression, found ',' (a 'let' is a number)");
    expect_refused({"half=1/0"}, "division by zero");
    expect_refused({"camera.fov=30 40"}, "expected nothing more, found '40' ('fov' is one value)");
    expect_refused({"camera.fov=30 eye: 0,0,0"},
                   "expected nothing more, found 'eye' ('fov' is one value)");
    expect_refused({"camera.fov=200"},
                   "camera: 'fov' is 200: it must lie between 0 and 180 degrees");
    expect_refused({"render.samples=0.5"}, "expected a whole number, found 0.5");
    expect_refused({"render.samples=0"}, "render: 'samples' is 0: it must lie in 1..65536");
    expect_refused({"render.shading=phong"},
                   "expected constant, low-pass, high-pass or facet, found 'phong'");
    expect_refused({"image.size=64x48"}, "expected ',', found 'x48' ('size' takes columns,rows)");
}

TEST_F(Set, what_can_stand_several_times_cannot_be_set) {
    for (const char* word : {"scale", "rotate", "translate", "matrix"}) {
        expect_refused({std::string("object.a.") + word + "=1,1,1"},
                       std::string("'") + word +
                           "' can stand several times: name its number by a "
                           "'let' and set that");
    }
    expect_refused({"ifs.tree.color=1,0,0,1"}, "'color' belongs to a map: say ifs.NAME.MAP.color");
    expect_refused({"ifs.tree.stem.start=1"},
                   "a map's values that can be set are its color and its weight");
}

TEST_F(Set, a_text_that_is_no_setting_is_refused) {
    for (const char* text : {"", "fov", "=3", "camera.fov"}) {
        try {
            (void)parse_setting(text);
            ADD_FAILURE() << text;
        } catch (const Error& error) {
            EXPECT_EQ(error.what(), std::string("--set: found \"") + text +
                                        "\", expected NAME=VALUE or BLOCK.DIRECTIVE=VALUE");
        }
    }
    expect_refused({"half="}, "expected a value");
    expect_refused({"camera..fov=3"}, "expected camera.DIRECTIVE or camera.NAME.DIRECTIVE");
    expect_refused({"image.a.size=3,3"}, "a scene has one image: say image.size");
}

TEST_F(Set, a_scenes_own_mistake_stays_the_scenes) {
    folder.write("s.pxm", "camera { fov: 200 }\nifs a { newmap scale: 0.5 }\n");
    Diagnostics diagnostics;
    const Scene scene =
        parse_scene(folder.path("s.pxm"), parse_settings({"image.size=8,8"}), diagnostics);
    EXPECT_FALSE(diagnostics.has_errors());
    EXPECT_EQ(scene.camera->fov, 200);
    EXPECT_EQ(
        with("camera { fov: 200 }\nifs a { newmap scale: 0.5 }\n", {"camera.fov=20"}).camera->fov,
        20);
}

}  // namespace
}  // namespace pxm::host
