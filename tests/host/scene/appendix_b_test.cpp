// Appendix B's listings as printed (with the `newmap` lines the scan lost) are scenes.
#include <gtest/gtest.h>

#include "tests/host/scene/scene_text.hpp"

namespace pxm::host {
namespace {

const char* const grass = R"(ifs grass {
    newmap
    scale: 0.707,0.96,0.707
    rotate: y,45
    translate: -1,0,0
    newmap
    scale: 0.707,0.96,0.707
    rotate: y,45
    translate: 1,0,0
    newmap
    scale: 0.25,0.01,0.01
    rotate: z,90
    translate: 0,0.707,0
}

object grass {
    sphere: (0,0,0) 3
    color: 0,0.7,0.2,1
    ifs: grass
    scale: 4,0.1,4
}
)";

const char* const elm = R"(ifs elm {
    newmap
    rotate: y,90
    scale: 0.6,0.6,0.6
    rotate: x,40
    translate: 0,1,0
    color: 0,1,0,0.05
    newmap
    rotate: y,75
    scale: 0.55,0.55,0.55
    rotate: x,-50
    translate: 0,0.9,0
    color: 0,0.9,0.2,0.05
    newmap
    rotate: y,105
    scale: 0.5,0.5,0.5
    rotate: z,60
    translate: 0,0.95,0
    color: 0.2,0.9,0,0.05
    newmap
    rotate: y,95
    scale: 0.45,0.45,0.45
    rotate: z,-35
    translate: 0,0.8,0
    color: 0.4,0.8,0.4,0.05
    newmap
    rotate: y,35
    scale: 0.055,0.25,0.055
    translate: 0,0.2,0
    color: 0.4,0.3,0.1,1
    newmap
    rotate: y,175
    scale: 0.055,0.25,0.055
    translate: 0,0.35,0
    color: 0.4,0.3,0.1,1
    newmap
    rotate: y,50
    scale: 0.0525,0.25,0.0525
    translate: 0,0.5,0
    color: 0.4,0.3,0.1,1
    newmap
    rotate: y,255
    scale: 0.08,-0.25,0.08
    translate: 0,0.4,0
    color: 0.4,0.3,0.1,1
    newmap
    rotate: y,145
    scale: 0.065,-0.25,0.065
    translate: 0,0.55,0
    color: 0.4,0.3,0.1,1
    newmap
    rotate: y,305
    scale: 0.0575,-0.25,0.0575
    translate: 0,0.7,0
    color: 0.4,0.3,0.1,1
    newmap
    rotate: y,210
    scale: 0.05,-0.25,0.05
    translate: 0,0.85,0
    color: 0.4,0.3,0.1,1
}
)";

const char* const pine = R"(ifs pine {
    newmap
    scale: 0.2,0.7,0.2
    rotate: z,96
    translate: 0,0.1,0
    color: 0,0.6,0,0.1
    newmap
    scale: 0.2,0.7,0.2
    rotate: z,90
    rotate: y,63
    translate: 0,0.1,0
    color: 0,0.6,0,0.1
    newmap
    scale: 0.2,0.7,0.2
    rotate: z,93
    rotate: y,104
    translate: 0,0.1,0
    color: 0,0.6,0,0.1
    newmap
    scale: 0.2,0.7,0.2
    rotate: z,97
    rotate: y,167
    translate: 0,0.1,0
    color: 0,0.6,0,0.1
    newmap scale: 0.2,0.7,0.2 rotate: z,95 rotate: y,253 translate: 0,0.1,0 color: 0,0.6,0,0.1
    newmap
    scale: 0.2,0.7,0.2
    rotate: z,100
    rotate: y,311
    translate: 0,0.1,0
    color: 0,0.6,0,0.1
    newmap
    rotate: y,31
    scale: 0.82,0.84,0.82
    translate: 0,0.15,0
    color: 0,0.6,0.6,0.2
}
object pine {
    cone
    color: 1,0,0,0
    ifs: pine
    scale: 1.5,2,1.5
    translate: 1,0.1,0
}
)";

const char* const tetra = R"(ifs tetra { newmap

scale: 0.5,0.5,0.5
translate: 0,0.5,0

newmap
scale: 0.5,0.5,0.5
translate: 0,-0.166,-0.472

newmap

scale: 0.5,0.5,0.5
translate: 0.409,-0.166,0.236

newmap

scale: 0.5,0.5,0.5
translate: -0.409,-0.166,0.236

}
)";

Scene accepted(const std::string& text) {
    const Scene scene = test::parsed(text);
    Diagnostics diagnostics;
    check_scene(scene, diagnostics);
    EXPECT_EQ(diagnostics.text(scene.files), "");
    return scene;
}

TEST(AppendixB, the_grass_lies_in_a_sphere_and_is_mowed) {
    const Scene scene = accepted(grass);
    EXPECT_EQ(scene.ifs.at(0).maps.size(), 3U);
    const ObjectBlock& object = scene.objects.at(0);
    EXPECT_EQ(object.name, "grass");
    EXPECT_EQ(object.ifs, "grass");
    EXPECT_EQ(std::get<SphereVolume>(*object.volume), (SphereVolume{{0, 0, 0}, 3}));
    EXPECT_EQ(object.color, glm::dvec4(0, 0.7, 0.2, 1));
    EXPECT_EQ(compose(object.commands), scaling({4, 0.1, 4}));
}

TEST(AppendixB, the_elm_has_eleven_maps_with_colors) {
    const Scene scene = accepted(elm);
    const auto& maps = scene.ifs.at(0).maps;
    ASSERT_EQ(maps.size(), 11U);
    EXPECT_EQ(maps[0].color, glm::dvec4(0, 1, 0, 0.05));
    EXPECT_EQ(maps[10].color, glm::dvec4(0.4, 0.3, 0.1, 1));
    EXPECT_LT(determinant(compose(maps[7].commands)), 0);  // an inverted trunk
}

TEST(AppendixB, the_pine_stands_in_the_cone) {
    const Scene scene = accepted(pine);
    EXPECT_EQ(scene.ifs.at(0).maps.size(), 7U);
    EXPECT_TRUE(std::holds_alternative<ConeVolume>(*scene.objects.at(0).volume));
    EXPECT_EQ(scene.objects[0].color, glm::dvec4(1, 0, 0, 0));
    EXPECT_EQ(compose(scene.objects[0].commands).translation, glm::dvec3(1, 0.1, 0));
}

TEST(AppendixB, newlines_mean_nothing) {
    const Scene scene = accepted(tetra);
    EXPECT_EQ(scene.ifs.at(0).maps.size(), 4U);
    std::string in_one_line = tetra;
    for (char& c : in_one_line)
        if (c == '\n') c = ' ';
    EXPECT_TRUE(test::parsed(in_one_line) == scene);
    EXPECT_TRUE(scene.objects.empty());
}

TEST(AppendixB, all_listings_together_are_one_scene) {
    std::string all;
    for (const char* listing : {grass, elm, pine, tetra}) all += listing;
    const Scene scene = accepted(all);
    EXPECT_EQ(scene.ifs.size(), 4U);
    EXPECT_EQ(scene.objects.size(), 2U);
}

}  // namespace
}  // namespace pxm::host
