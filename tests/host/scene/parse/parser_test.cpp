// Laws of host/scene/parse/parser: what each directive means.
#include "host/scene/parse/parser.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "host/scene/check/limits.hpp"
#include "tests/host/scene/scene_text.hpp"
#include "tests/support/folder.hpp"

namespace pxm::host {
namespace {

using test::parse_messages;
using test::parsed;

TEST(Parser, commands_keep_their_order_and_values) {
    const Scene scene = parsed(
        "ifs a { newmap first scale: 0.5 rotate: y,45 translate: -1,0,1/2\n"
        "newmap matrix: 1,2,3,4,5,6,7,8,9,10,11,12 weight: 2 color: 0,1,0,0.5 scale: 1,2,3 }");
    const IfsBlock& ifs = scene.ifs.at(0);
    ASSERT_EQ(ifs.maps.size(), 2U);
    EXPECT_EQ(ifs.maps[0].name, "first");
    const auto& commands = ifs.maps[0].commands;
    ASSERT_EQ(commands.size(), 3U);
    EXPECT_EQ(std::get<ScaleCommand>(commands[0].kind).factors, glm::dvec3(0.5));
    EXPECT_EQ(std::get<RotateCommand>(commands[1].kind), (RotateCommand{Axis::y, 45}));
    EXPECT_EQ(std::get<TranslateCommand>(commands[2].kind).offset, glm::dvec3(-1, 0, 0.5));
    const Affine& matrix = std::get<MatrixCommand>(ifs.maps[1].commands[0].kind).map;
    EXPECT_EQ(matrix.linear[0], glm::dvec3(1, 2, 3));
    EXPECT_EQ(matrix.linear[2], glm::dvec3(7, 8, 9));
    EXPECT_EQ(matrix.translation, glm::dvec3(10, 11, 12));
    EXPECT_EQ(ifs.maps[1].weight, 2);
    EXPECT_EQ(ifs.maps[1].color, glm::dvec4(0, 1, 0, 0.5));
    EXPECT_EQ(std::get<ScaleCommand>(ifs.maps[1].commands[1].kind).factors, glm::dvec3(1, 2, 3));
}

TEST(Parser, newmap_takes_the_next_word_as_a_name_if_no_colon_follows_it) {
    const Scene scene = parsed("rifs a { newmap leaf newmap scale: 1 newmap newmap on }");
    const auto& maps = scene.ifs.at(0).maps;
    ASSERT_EQ(maps.size(), 4U);
    EXPECT_EQ(maps[0].name, "leaf");
    EXPECT_EQ(maps[1].name, "");
    EXPECT_EQ(maps[2].name, "");
    EXPECT_EQ(maps[3].name, "on");
}

TEST(Parser, maps_are_referred_to_by_name_or_number) {
    const IfsBlock ifs =
        parsed("ifs a { newmap u newmap follow: u->2,u follow: 2 -> u start: 1, u }").ifs.at(0);
    ASSERT_EQ(ifs.follow.size(), 2U);
    EXPECT_EQ(std::get<std::string>(ifs.follow[0].map.map), "u");
    EXPECT_EQ(std::get<long>(ifs.follow[0].followers.at(0).map), 2);
    EXPECT_EQ(std::get<std::string>(ifs.follow[0].followers.at(1).map), "u");
    EXPECT_EQ(std::get<long>(ifs.follow[1].map.map), 2);
    ASSERT_EQ(ifs.start.size(), 2U);
    EXPECT_EQ(std::get<long>(ifs.start[0].map), 1);
}

TEST(Parser, a_tetrahedron_takes_four_points_to_four) {
    const std::string points = "(0,0,0)(1,0,0),(0,1,0)(0,0,1)";
    const Scene scene =
        parsed("ifs a { newmap tetrahedron: " + points + "->(1,0,0)(2,0,0)(1,1,0)(1,0,1/2) }");
    const auto command = std::get<TetrahedronCommand>(scene.ifs.at(0).maps.at(0).commands[0].kind);
    EXPECT_EQ(command.from[2], glm::dvec3(0, 1, 0));
    EXPECT_EQ(command.to[3], glm::dvec3(1, 0, 0.5));
}

TEST(Parser, volumes_may_leave_out_the_comma_after_a_point) {
    const Scene scene = parsed(
        "object a { sphere: (1,2,3) 4 } object b { sphere: (1,2,3), 4 } object c { box: "
        "(0,0,0)(1,1,1) }"
        "object d { cone } object e { hull } object f { auto ifs: x } object g { cylinder }"
        "object h { sphere } object i { box }");
    EXPECT_EQ(scene.objects[0].volume, scene.objects[1].volume);
    EXPECT_EQ(std::get<SphereVolume>(*scene.objects[0].volume), (SphereVolume{{1, 2, 3}, 4}));
    EXPECT_EQ(std::get<BoxVolume>(*scene.objects[2].volume), (BoxVolume{{0, 0, 0}, {1, 1, 1}}));
    EXPECT_TRUE(std::holds_alternative<ConeVolume>(*scene.objects[3].volume));
    EXPECT_TRUE(std::holds_alternative<HullVolume>(*scene.objects[4].volume));
    EXPECT_TRUE(std::holds_alternative<AutoVolume>(*scene.objects[5].volume));
    EXPECT_TRUE(std::holds_alternative<CylinderVolume>(*scene.objects[6].volume));
    EXPECT_EQ(std::get<SphereVolume>(*scene.objects[7].volume), (SphereVolume{{0, 0, 0}, 1}));
    EXPECT_EQ(std::get<BoxVolume>(*scene.objects[8].volume), BoxVolume{});
}

TEST(Parser, every_other_block_keeps_what_it_is_given) {
    const Scene scene = parsed(
        "object o { ifs: a color: 1,0,0,0 opacity: .5 diffuse: .4 reflect: .3 levels: 2 scale: 2 }"
        "plane p { point: 0,1,0 normal: 0,1,0 color: 1,1,1 texture: t, u reflect: 1/4 }"
        "texture t { file: \"wood grain.png\" size: 1,2 color: 0,0,0 color2: 1,1,1 }"
        "texture u { ifs: a } texture w { wood }"
        "light { position: 1,2,3 color: 1,1,0 shadow: on } light sun { direction: 0,1,0 shadow: "
        "off }"
        "image { size: 2*320,480 crop: 0,1,2,3 }");
    const ObjectBlock& object = scene.objects.at(0);
    EXPECT_EQ(object.ifs, "a");
    EXPECT_EQ(object.opacity, 0.5);
    EXPECT_EQ(object.diffuse, 0.4);
    EXPECT_EQ(object.reflect, 0.3);
    EXPECT_EQ(object.levels, 2);
    ASSERT_EQ(scene.planes.at(0).textures.size(), 2U);
    EXPECT_EQ(scene.planes.at(0).textures.at(0).name, "t");
    EXPECT_EQ(scene.planes.at(0).textures.at(1).name, "u");
    EXPECT_EQ(scene.planes.at(0).reflect, 0.25);
    EXPECT_EQ(std::get<FileTexture>(*scene.textures.at(0).source).file, "wood grain.png");
    EXPECT_EQ(scene.textures.at(0).size, glm::dvec2(1, 2));
    EXPECT_EQ(std::get<IfsTexture>(*scene.textures.at(1).source).ifs, "a");
    EXPECT_TRUE(std::holds_alternative<WoodTexture>(*scene.textures.at(2).source));
    EXPECT_EQ(scene.lights.at(0).location, glm::dvec3(1, 2, 3));
    EXPECT_EQ(scene.lights.at(0).shadow, true);
    EXPECT_EQ(scene.lights.at(1).shadow, false);
    EXPECT_EQ(scene.lights.at(1).name, "sun");
    EXPECT_EQ(scene.image->size, (PixelSize{640, 480}));
    EXPECT_EQ(scene.image->crop, (CropWindow{0, 1, 2, 3}));
}

TEST(Parser, render_words_name_their_values) {
    const RenderBlock render =
        *parsed(
             "render { shading: low-pass covers: on samples: 4 intersect: wide numeric: double "
             "detail: 2 lipschitz: polar volume: oriented heap: 16 bounces: 3 }")
             .render;
    EXPECT_EQ(render.shading, Shading::low_pass);
    EXPECT_EQ(std::get<Covers>(*render.covers), (Covers{1.0 / 20, 2}));
    EXPECT_EQ(render.samples, 4);
    EXPECT_EQ(render.intersect, IntersectMethod::wide);
    EXPECT_EQ(render.numeric, Numeric::double_);
    EXPECT_EQ(render.detail, 2);
    EXPECT_EQ(render.lipschitz, LipschitzMethod::polar);
    EXPECT_EQ(render.volume, VolumeKind::oriented);
    EXPECT_EQ(render.heap, 16);
    EXPECT_EQ(render.bounces, 3);
    EXPECT_EQ(parsed("render { shading: high-pass }").render->shading, Shading::high_pass);
    const auto off = parsed("render { covers: off }").render->covers;
    EXPECT_TRUE(std::holds_alternative<CoversOff>(*off));
    const auto own = parsed("render { covers: 0.1, 3 }").render->covers;
    EXPECT_EQ(std::get<Covers>(*own), (Covers{0.1, 3}));
}

TEST(Parser, plain_camera_coordinates_keep_their_digits) {
    const std::string digits = "-0.74364388703715870475219150611477";
    const CameraBlock camera =
        *parsed("camera { eye: " + digits + ", +1e-40, 1/4 look: -(1),2,-pi }").camera;
    EXPECT_EQ((*camera.eye)[0].text, digits);
    EXPECT_EQ((*camera.eye)[0].value, -0.74364388703715870475219150611477);
    EXPECT_EQ((*camera.eye)[1].text, "1e-40");
    EXPECT_EQ((*camera.eye)[2].text, "");
    EXPECT_EQ((*camera.eye)[2].value, 0.25);
    EXPECT_EQ((*camera.look)[0].text, "");
    EXPECT_EQ((*camera.look)[0].value, -1);
    EXPECT_EQ((*camera.look)[1].text, "2");
    EXPECT_EQ((*camera.look)[2].text, "");
}

TEST(Parser, let_names_numbers_for_what_comes_later) {
    const Scene scene = parsed("let half = 1/2 let q = half*half ifs a { newmap scale: q }");
    EXPECT_EQ(std::get<ScaleCommand>(scene.ifs[0].maps[0].commands[0].kind).factors.x, 0.25);
}

TEST(Parser, an_include_is_relative_to_the_including_file_and_read_once) {
    const test::Files files{
        {"lib/a.pxm", "include: \"b.pxm\" include: \"../lib/b.pxm\" ifs a { newmap scale: c }"},
        {"lib/b.pxm", "let c = 1/4 ifs b { newmap }"}};
    const Scene scene = parsed(
        "include: \"lib/a.pxm\" include: \"./lib/./b.pxm\" object o { ifs: a scale: c }", files);
    ASSERT_EQ(scene.ifs.size(), 2U);
    EXPECT_EQ(scene.ifs[0].name, "b");
    EXPECT_EQ(scene.files.size(), 3U);
    EXPECT_EQ(scene.ifs[0].position.file, 2);
}

TEST(Parser, a_cycle_of_includes_is_reported_where_it_closes) {
    const test::Files files{{"a.pxm", "ifs a { newmap }\ninclude: \"s.pxm\""}};
    EXPECT_EQ(parse_messages("include: \"a.pxm\"", files),
              "a.pxm:2:10: error: \"s.pxm\" includes itself\n"
              "    include: \"s.pxm\"\n"
              "             ^");
}

TEST(Parser, includes_nest_to_a_limit) {
    test::Files files;
    for (int i = 0; i < 100; ++i)
        files[std::to_string(i)] = "include: \"" + std::to_string(i + 1) + "\"";
    EXPECT_NE(parse_messages("include: \"0\"", files).find("includes nested deeper than 32"),
              std::string::npos);
}

TEST(Parser, a_missing_include_is_a_scene_error_and_a_missing_scene_a_file_error) {
    EXPECT_EQ(parse_messages("include: \"no.pxm\" ifs a { newmap }"),
              "s.pxm:1:10: error: cannot include \"no.pxm\": no.pxm: no such file\n"
              "    include: \"no.pxm\" ifs a { newmap }\n"
              "             ^");
    for (const char* path : {"/nonexistent/s.pxm", "/", "/dev/zero"}) {
        Diagnostics diagnostics;
        try {
            (void)parse_scene(path, diagnostics);
            ADD_FAILURE() << path;
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::file) << error.what();
        }
    }
}

TEST(Parser, a_scene_names_files_below_its_folder_only) {
    const test::Folder folder;
    std::filesystem::create_directory(folder.path("scenes"));
    folder.write("part.pxm", "ifs a { newmap scale: 0.5 }");
    folder.write("scenes/a.pxm", "include: \"../part.pxm\"\ntexture t { file: \"../t.png\" }");
    const std::string scene = folder.path("scenes/a.pxm");
    const auto messages = [&](const std::vector<std::string>& allowed) {
        Diagnostics diagnostics;
        const Scene read = parse_scene(scene, diagnostics, allowed);
        return diagnostics.text(read.files);
    };
    const std::string why =
        fmt::format("lies outside the scene's folder; if you trust the scene, add --allow {}",
                    std::filesystem::canonical(folder.path()).string());
    EXPECT_EQ(messages({}),
              fmt::format("{0}:1:10: error: cannot include \"../part.pxm\": {1}: {2}\n"
                          "    include: \"../part.pxm\"\n             ^\n"
                          "{0}:2:19: error: texture \"t\": {3}: {2}\n"
                          "    texture t {{ file: \"../t.png\" }}\n                      ^",
                          scene, folder.path("part.pxm"), why, folder.path("scenes/../t.png")));
    EXPECT_EQ(messages({folder.path()}), "") << "no plane shows the texture: it need not be there";
}

TEST(Parser, a_scene_has_so_many_files_at_most) {
    test::Files files;
    std::string text;
    for (std::size_t i = 0; i < files_a_scene; ++i) {
        files[std::to_string(i)] = "";
        text += fmt::format("include: \"{}\"\n", i);
    }
    const std::string messages = parse_messages(text + "ifs a { newmap scale: 0.5 }", files);
    EXPECT_TRUE(messages.starts_with("s.pxm:1000:10: error: the scene has more than 1000 files"))
        << messages;
}

TEST(Parser, a_scene_is_read_from_the_file_system) {
    const auto folder = std::filesystem::path(testing::TempDir()) / "pxm_parser_test";
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "part.pxm") << "ifs a { newmap scale: 0.5 }\r\n";
    std::ofstream(folder / "main.pxm") << "\xef\xbb\xbfinclude: \"part.pxm\"\r\n# end";
    Diagnostics diagnostics;
    const Scene scene = parse_scene((folder / "main.pxm").string(), diagnostics);
    EXPECT_EQ(diagnostics.text(scene.files), "");
    EXPECT_EQ(scene.ifs.size(), 1U);
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace pxm::host
