// Laws of host/scene/check/check: whole texts for some, place and words for all.
#include "host/scene/check/check.hpp"

#include <gtest/gtest.h>

#include "host/scene/check/limits.hpp"
#include "tests/host/scene/scene_text.hpp"

namespace pxm::host {
namespace {

using test::check_messages;

const std::string an_ifs = "ifs a { newmap scale: 0.5 } ";

/// The only message's first line without its place; other counts of messages show in full.
std::string complaint(const std::string& blocks) {
    const std::string text = check_messages(an_ifs + blocks);
    const std::string head = text.substr(0, text.find('\n'));
    const std::size_t at = head.find(": error: ");
    if (at == std::string::npos || text.find("error:", at + 9) != std::string::npos) return text;
    return head.substr(at + 9);
}

TEST(Check, a_sound_scene_has_no_complaint) {
    EXPECT_EQ(complaint("object o { ifs: a sphere: (0,0,0) 3 scale: 4,0.1,4 levels: 0 opacity: 1 } "
                        "plane f { normal: 0,1,0 texture: t } texture t { ifs: a size: 1,1 } "
                        "light l { position: 0,0,0 } camera { eye: 0,0,-5 look: 0,0,0 fov: 179 } "
                        "image { size: 65536,1 crop: 0,0,65536,1 } render { bounces: 0 heap: 1 }"),
              "");
}

TEST(Check, an_error_names_block_and_map_and_stands_at_its_place) {
    EXPECT_EQ(check_messages("ifs fern {\n  newmap stem\n    color: 1,-1,0,0.5\n}"),
              "s.pxm:2:3: error: ifs \"fern\": map \"stem\": 'color' is 1,-1,0: "
              "no component may be negative\n"
              "    newmap stem\n"
              "    ^");
    EXPECT_EQ(check_messages("ifs a {\n newmap\n tetrahedron: (0,0,0)(1,0,0)(2,0,0)(0,0,1) -> "
                             "(0,0,0)(1,0,0)(2,0,0)(0,0,1)\n}"),
              "s.pxm:3:2: error: ifs \"a\": map 1: the four points of the tetrahedron lie in a "
              "plane\n"
              "    tetrahedron: (0,0,0)(1,0,0)(2,0,0)(0,0,1) -> (0,0,0)(1,0,0)(2,0,0)(0,0,1)\n"
              "    ^");
}

TEST(Check, a_name_is_defined_once_in_its_kind) {
    EXPECT_EQ(complaint("ifs a { newmap }"), "ifs \"a\" is defined twice (first in line 1)");
    EXPECT_EQ(complaint("ifs b { newmap m newmap m }"),
              "map \"m\" is defined twice (first in line 1)");
    EXPECT_EQ(complaint("object a { cone }"), "");
    EXPECT_EQ(complaint("object b { cone } object b { cone }"),
              "object \"b\" is defined twice (first in line 1)");
    EXPECT_EQ(complaint("object { cone } object { cone }"), "");
    EXPECT_EQ(complaint("light l { direction: 1,0,0 } light l { direction: 1,0,0 }"),
              "light \"l\" is defined twice (first in line 1)");
    EXPECT_EQ(complaint("texture l { wood } texture l { wood }"),
              "texture \"l\" is defined twice (first in line 1)");
    EXPECT_EQ(complaint("plane l { normal: 1,0,0 } plane l { normal: 1,0,0 }"),
              "plane \"l\" is defined twice (first in line 1)");
}

TEST(Check, every_name_is_defined) {
    EXPECT_EQ(complaint("object o { ifs: b }"), "there is no ifs \"b\"");
    EXPECT_EQ(complaint("plane o { normal: 1,0,0 texture: b }"), "there is no texture \"b\"");
    EXPECT_EQ(complaint("texture o { ifs: b }"), "there is no ifs \"b\"");
    EXPECT_EQ(check_messages("object o { ifs: a } ifs a { newmap }"), "");
}

TEST(Check, maps_are_finite) {
    EXPECT_EQ(complaint("ifs b { newmap newmap scale: 1e200 scale: 1e200 }"),
              "ifs \"b\": map 2: the map is not finite");
    EXPECT_EQ(complaint("ifs b { newmap weight: -1 }"),
              "ifs \"b\": map 1: 'weight' is -1: it must not be negative");
    EXPECT_EQ(complaint("ifs b { newmap color: 1,1,1,2 }"),
              "ifs \"b\": map 1: 'color' has a = 2: it must lie in 0..1");
    EXPECT_EQ(complaint("ifs b { newmap scale: 1,0,1 }"), "");
}

TEST(Check, objects_have_something_to_show_and_an_inverse) {
    EXPECT_EQ(complaint("object o { }"), "object \"o\": it needs an 'ifs' or a volume");
    EXPECT_EQ(complaint("object o { auto }"), "object \"o\": it needs an 'ifs' or a volume");
    EXPECT_EQ(complaint("object { ifs: a scale: 4,0,4 }"),
              "object: its matrix is singular: it squashes space flat");
    EXPECT_EQ(complaint("object o { ifs: a scale: 1e-30 }"), "");
    EXPECT_EQ(complaint("object o { ifs: a sphere: (0,0,0) 0 }"),
              "object \"o\": the sphere's radius is 0: it must be greater than 0");
    EXPECT_EQ(complaint("object o { ifs: a box: (0,0,0)(1,0,1) }"),
              "object \"o\": the box is empty: its y runs from 0 to 0");
    EXPECT_EQ(complaint("object o { ifs: a opacity: 1.5 }"),
              "object \"o\": 'opacity' is 1.5: it must lie in 0..1");
    EXPECT_EQ(complaint("object o { ifs: a diffuse: -1 }"),
              "object \"o\": 'diffuse' is -1: it must lie in 0..1");
    EXPECT_EQ(complaint("object o { ifs: a reflect: 2 }"),
              "object \"o\": 'reflect' is 2: it must lie in 0..1");
    EXPECT_EQ(complaint("object o { ifs: a levels: -1 }"),
              "object \"o\": 'levels' is -1: it must be at least 0");
}

TEST(Check, settings_are_in_range) {
    EXPECT_EQ(complaint("plane p { }"), "plane \"p\": it needs a 'normal'");
    EXPECT_EQ(complaint("plane p { normal: 0,0,0 }"),
              "plane \"p\": 'normal' is 0,0,0: it must not be zero");
    EXPECT_EQ(complaint("plane p { normal: 0,1,0 reflect: 2 }"),
              "plane \"p\": 'reflect' is 2: it must lie in 0..1");
    EXPECT_EQ(complaint("texture t { }"), "texture \"t\": it needs 'file', 'ifs' or 'wood'");
    EXPECT_EQ(complaint("texture t { wood size: 0,1 }"),
              "texture \"t\": 'size' is 0: it must be greater than 0");
    EXPECT_EQ(complaint("light { }"), "light: it needs a 'direction' or a 'position'");
    EXPECT_EQ(complaint("light { direction: 1,0,0 position: 1,0,0 }"),
              "light: it has both 'direction' and 'position'");
    EXPECT_EQ(complaint("light { direction: 0,0,0 }"),
              "light: 'direction' is 0,0,0: it must not be zero");
    EXPECT_EQ(complaint("render { ambient: -1,0,0 }"),
              "render: 'ambient' is -1,0,0: no component may be negative");
    EXPECT_EQ(complaint("render { samples: 0 }"),
              "render: 'samples' is 0: it must lie in 1..65536");
    EXPECT_EQ(complaint("render { detail: 0 }"),
              "render: 'detail' is 0: it must be greater than 0");
    EXPECT_EQ(complaint("render { heap: 65537 }"),
              "render: 'heap' is 65537: it must lie in 1..65536");
    EXPECT_EQ(complaint("render { bounces: 65 }"), "render: 'bounces' is 65: it must lie in 0..64");
    EXPECT_EQ(complaint("render { covers: 2,1 }"),
              "render: 'covers' is 2,1: it must be tmin,tmax with 0 < tmin < tmax");
    EXPECT_EQ(complaint("render { covers: on }"), "");
}

TEST(Check, the_camera_has_a_view) {
    EXPECT_EQ(complaint("camera { fov: 180 }"),
              "camera: 'fov' is 180: it must lie between 0 and 180 degrees");
    EXPECT_EQ(complaint("camera { fov: 0 }"),
              "camera: 'fov' is 0: it must lie between 0 and 180 degrees");
    EXPECT_EQ(complaint("camera { orthographic: 0 }"),
              "camera: 'orthographic' is 0: it must be greater than 0");
    EXPECT_EQ(complaint("camera main { eye: 1,2,3 look: 1.0,20e-1,03 }"),
              "camera \"main\": 'eye' and 'look' are the same point");
    EXPECT_EQ(complaint("camera { eye: 0,5,0 look: 0,0,0 }"),
              "camera: 'up' is 0,1,0: the camera looks along it");
    EXPECT_EQ(complaint("camera { eye: 0,5,0 look: 0,0,0 up: 0,0,1 }"), "");
    EXPECT_EQ(complaint("camera { up: 0,0,0 }"), "camera: 'up' is 0,0,0: it must not be zero");
}

TEST(Check, points_that_differ_beyond_a_double_are_different) {
    EXPECT_EQ(complaint("camera { eye: 0.1,0,-1.00000000000000000000001 look: 0.1,0,-1 }"), "");
    EXPECT_EQ(complaint("camera { eye: 0.1,0,-1e-999999999999999999999 look: 0.1,0,-0 }"), "");
    EXPECT_NE(complaint("camera { eye: 0.1,0,0 look: 0.1,0,-0 }"), "");
}

TEST(Check, the_image_has_pixels_and_the_crop_is_inside_it) {
    EXPECT_EQ(complaint("image { size: 0,10 }"), "image: 'size' is 0: it must lie in 1..65536");
    EXPECT_EQ(complaint("image { size: 10,1000000000 }"),
              "image: 'size' is 1000000000: it must lie in 1..65536");
    EXPECT_EQ(complaint("image { size: 10,10 crop: 0,0,0,5 }"),
              "image: 'crop' is empty: it is x0,y0,x1,y1 with x0 < x1 and y0 < y1");
    EXPECT_EQ(complaint("image { size: 10,10 crop: 0,0,11,10 }"),
              "image: 'crop' is not inside the image of 10,10");
    EXPECT_EQ(complaint("image { crop: 0,0,640,480 }"), "");
    EXPECT_EQ(complaint("image { crop: -1,0,640,480 }"),
              "image: 'crop' is not inside the image of 640,480");
}

TEST(Check, there_is_something_to_render) {
    EXPECT_EQ(check_messages("light { direction: 1,0,0 }"),
              "s.pxm:1:1: error: nothing to render: the scene has no ifs, object or plane\n"
              "    light { direction: 1,0,0 }\n"
              "    ^");
}

TEST(Check, maps_are_counted) {
    Scene scene;
    scene.ifs.resize(1);
    scene.ifs[0].name = "a";
    scene.ifs[0].maps.resize(maps_an_ifs + 1);
    Diagnostics too_many;
    check_scene(scene, too_many);
    EXPECT_EQ(too_many.text({}), "error: ifs \"a\": 65537 maps, but an ifs may have 65536");
    scene.ifs[0].maps.pop_back();
    Diagnostics enough;
    check_scene(scene, enough);
    EXPECT_EQ(enough.text({}), "");
    std::string text = "ifs a { ";
    for (std::size_t i = 0; i <= maps_an_ifs; ++i) text += "newmap ";
    EXPECT_NE(test::parse_messages(text + "}").find("more than 65536 maps in an ifs"),
              std::string::npos);
}

}  // namespace
}  // namespace pxm::host
