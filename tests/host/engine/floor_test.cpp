// Laws of floors in pictures: what stands in front, what the engines agree on, what a texture file
// can do wrong, and what textures take of the machine.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "host/files/image_reader.hpp"
#include "host/node_program/module_table.hpp"
#include "host/output/pixel_values.hpp"
#include "host/scene/check/limits.hpp"
#include "host/scene/parse/parser.hpp"
#include "tests/support/floor_node.hpp"
#include "tests/support/folder.hpp"
#include "tests/support/oracle.hpp"
#include "tests/support/render_text.hpp"

namespace pxm::host {
namespace {

using test::compile_text;
using test::Folder;
using test::render_natively;

const std::string solid = std::string(test::tetra_text) + "object o { ifs: tetra }\n";
const std::string view = "camera { eye: 1,1.4,-4 look: 0,0.1,0 } image { size: 48,36 }\n";
const std::string gasket =
    "ifs gasket { newmap scale: 0.5 newmap scale: 0.5 translate: 0.5,0,0 "
    "newmap scale: 0.5 translate: 0,0.5,0 }\n";
const std::string floor_block = "plane floor { point: 0,-0.2,0 normal: 0,1,0 }\n";

/// A scene with all three kinds of texture, and the picture it needs.
std::string textured(const Folder& folder) {
    test::write_picture(folder.path("stripes.png"), 24, 16, [](long x, long y) {
        return glm::dvec3{x % 4 < 2 ? 0.9 : 0.2, 0.5, static_cast<double>(y) / 16};
    });
    return solid + gasket + view +
           fmt::format(
               "texture w {{ wood size: 1.5,0.2 }} texture g {{ ifs: gasket size: 1,1 }}\n"
               "texture p {{ file: \"{}\" size: 0.7,0.7 }}\n"
               "plane floor {{ point: 0,-0.2,0 normal: 0,1,0 texture: w, g }}\n"
               "plane wall {{ point: 0,0,2 normal: 0,0.1,-1 texture: p }}\n",
               folder.path("stripes.png"));
}

bool close(const PixelRecord& a, const PixelRecord& b) {
    return std::abs(a.color[0] - b.color[0]) < 0.01 && std::abs(a.color[1] - b.color[1]) < 0.01;
}

/// The Error of rendering a scene file, as "exit code: text".
std::string error_of(const std::string& path, const RenderRequest& how = {}) {
    RenderRequest request = how;
    request.scene_path = path;
    return test::error_of([&] { (void)render(request, {}); });
}

TEST(Floor, a_pixel_shows_what_is_nearer) {
    const Frame both =
        render_natively(compile_text(solid + view + floor_block), Numeric::single).frame;
    const Frame objects = render_natively(compile_text(solid + view), Numeric::single).frame;
    const Frame floor = render_natively(compile_text(view + floor_block), Numeric::single).frame;
    int in_front = 0;
    int behind = 0;
    for (std::size_t i = 0; i < both.pixels.size(); ++i) {
        const PixelRecord& pixel = both.pixels[i];
        // The scene unit of a scene without objects is another one: a plane alone is the same but
        // for rounding.
        const bool object =
            objects.pixels[i].z <= floor.pixels[i].z && std::isfinite(objects.pixels[i].z);
        if (object) {
            EXPECT_EQ(pixel.z, objects.pixels[i].z);
            EXPECT_EQ(pixel.object, 0);
            EXPECT_EQ(pixel.color[0], objects.pixels[i].color[0]);
            in_front += std::isfinite(floor.pixels[i].z) ? 1 : 0;
        } else if (std::isfinite(floor.pixels[i].z)) {
            EXPECT_FLOAT_EQ(pixel.z, floor.pixels[i].z);
            EXPECT_EQ(pixel.object, 1);
            behind += objects.pixels[i].object == 0 ? 1 : 0;
        }
    }
    EXPECT_GT(in_front, 50);
    EXPECT_GT(behind, 5);
}

TEST(Floor, its_pixels_say_where_and_what_it_is) {
    const Frame frame =
        render_natively(compile_text(solid + view + "plane a { point: 0,0,9 normal: 0,0,1 }" +
                                     "plane b { point: 0,-0.2,0 normal: 0,1,0 color: 0.5,1,0.25 }"
                                     "light { direction: 0,1,0 } render { ambient: 0.1,0.1,0.1 }"),
                        Numeric::double_)
            .frame;
    const PixelRecord& pixel = frame.at(2, 35);
    EXPECT_EQ(pixel.object, 2);  // after the objects, in the order of the scene
    EXPECT_EQ(pixel.level, 0);
    EXPECT_EQ(pixel.word, 0U);
    EXPECT_EQ(pixel.alpha, 1);
    EXPECT_EQ(pixel.normal[1], 1);
    const float lit = 0.1F + 0.8F;  // k_a c_a + k_d, Eq. 17.1
    EXPECT_FLOAT_EQ(pixel.color[0], 0.5F * lit);
    EXPECT_FLOAT_EQ(pixel.color[1], lit);
    EXPECT_EQ(frame.at(2, 1).object, 1);
    EXPECT_EQ(frame.at(2, 1).normal[2], -1);  // the wall's far side is seen
}

TEST(Floor, is_in_shadow_where_an_object_hides_the_light) {
    const std::string coarse = std::string(test::tetra_text) + "object o { ifs: tetra levels: 2 }";
    const std::string light =
        "light { direction: -1,0.7,0.8 shadow: on } render { ambient: 0,0,0 }";
    const CompiledScene scene = compile_text(coarse + view + floor_block + light);
    const Frame frame = render_natively(scene, Numeric::double_).frame;
    test::Oracle oracle(scene, 0x1p-48);
    int shadows = 0;
    int wrong = 0;
    for (long y = 0; y < 36; ++y) {
        for (long x = 0; x < 48; ++x) {
            if (frame.at(x, y).object != 1) continue;
            const test::Sight eye = oracle.sight(x, y);
            const double t = frame.at(x, y).z / scene.unit;
            const test::Sight to_light{eye.origin + t * eye.direction,
                                       glm::normalize(glm::dvec3{-1, 0.7, 0.8})};
            const bool hidden = !oracle.look(to_light).empty();
            shadows += hidden ? 1 : 0;
            wrong += hidden != (frame.at(x, y).color[0] == 0) ? 1 : 0;
        }
    }
    EXPECT_GT(shadows, 40);
    EXPECT_LT(wrong, shadows / 5);
}

TEST(Floor, hides_the_light_that_comes_from_below) {
    const std::string below =
        "light { direction: 0,-1,-0.5 shadow: on } light { position: 0,-3,0 shadow: on }";
    const std::string dark = "render { ambient: 0,0,0 }";
    const Frame frame = render_natively(compile_text(solid + view + below + dark +
                                                     "plane { point: 0,-2,0 normal: 0,1,0 }"),
                                        Numeric::single)
                            .frame;
    const Frame open =
        render_natively(compile_text(solid + view + below + dark), Numeric::single).frame;
    double with = 0;
    double without = 0;
    for (std::size_t i = 0; i < frame.pixels.size(); ++i) {
        if (open.pixels[i].object != 0) continue;
        with += frame.pixels[i].color[0];
        without += open.pixels[i].color[0];
    }
    EXPECT_EQ(with, 0);
    EXPECT_GT(without, 3);
}

// A mirror shows what stands behind it in a scene where everything is mirrored.
TEST(Floor, that_mirrors_all_shows_the_scene_upside_down) {
    const std::string dim = "render { background: 0,0,0 }";
    const CompiledScene mirror =
        compile_text(solid + view + dim + "light { direction: 0.6,1,-0.3 }" +
                     "plane { point: 0,-0.5,0 normal: 0,1,0 reflect: 1 }");
    const CompiledScene behind = compile_text(
        std::string(test::tetra_text) + view + dim + "light { direction: 0.6,-1,-0.3 }" +
        "object o { ifs: tetra scale: 1,-1,1 translate: 0,-1,0 }");
    const Frame seen = render_natively(mirror, Numeric::double_).frame;
    const Frame expected = render_natively(behind, Numeric::double_).frame;
    int same = 0;
    int hits = 0;
    int pixels = 0;
    for (std::size_t i = 0; i < seen.pixels.size(); ++i) {
        if (seen.pixels[i].object != 1) continue;
        ++pixels;
        hits += expected.pixels[i].object == 0 ? 1 : 0;
        same += close(seen.pixels[i], expected.pixels[i]) ? 1 : 0;
    }
    EXPECT_GT(hits, 60);
    EXPECT_GT(same, pixels - hits / 4);
}

TEST(Floor, shows_through_covers_and_translucent_objects) {
    const std::string haze = std::string(test::tetra_text) +
                             "object o { ifs: tetra opacity: 0.25 levels: 0 color: 1,0,0,1 }";
    const std::string lit = "render { ambient: 1,1,1 } light { direction: 0,-1,0 color: 0,0,0 }";
    const Frame frame =
        render_natively(compile_text(haze + view + floor_block + lit), Numeric::single).frame;
    int through = 0;
    for (const PixelRecord& pixel : frame.pixels) {
        if (pixel.object != 1 || pixel.color[1] > 0.7F) continue;
        ++through;
        EXPECT_NEAR(pixel.color[0], 0.25 * 1 + 0.75 * 0.9, 1e-4);
        EXPECT_NEAR(pixel.color[1], 0.25 * 0 + 0.75 * 0.9, 1e-4);
        EXPECT_NEAR(pixel.alpha, 1, 1e-6);
    }
    EXPECT_GT(through, 50);
}

TEST(Floor, the_engines_make_the_same_picture_of_every_texture) {
    const Folder folder;
    const CompiledScene scene = compile_text(textured(folder));
    for (const Numeric numeric : {Numeric::dsp32, Numeric::single, Numeric::double_}) {
        const Frame native = render_natively(scene, numeric, 2).frame;
        const Frame machine = test::render_on("916", scene, numeric, 2).frame;
        EXPECT_TRUE(test::same_picture(native, machine));
    }
    EXPECT_TRUE(test::same_picture(test::render_on("964dX", scene, Numeric::dsp32, 2).frame,
                                   test::render_on("940", scene, Numeric::dsp32, 1).frame));
}

TEST(Floor, the_numbers_of_a_node_make_about_the_same_picture) {
    const Folder folder;
    const CompiledScene scene = compile_text(textured(folder));
    const Frame exact = render_natively(scene, Numeric::double_, 2).frame;
    for (const Numeric numeric : {Numeric::dsp32, Numeric::single}) {
        const Frame frame = render_natively(scene, numeric, 2).frame;
        int wrong = 0;
        for (std::size_t i = 0; i < frame.pixels.size(); ++i) {
            if (exact.pixels[i].object < 1) continue;
            wrong += std::abs(frame.pixels[i].color[0] - exact.pixels[i].color[0]) > 0.02 ? 1 : 0;
        }
        EXPECT_LT(wrong, 10);
    }
}

TEST(Floor, a_pixel_that_shows_a_plane_is_explained) {
    const Folder folder;
    folder.write("scene.pxm", solid + view + floor_block);
    RenderRequest request;
    request.scene_path = folder.path("scene.pxm");
    const Frame frame = render(request, {}).frame;
    int planes = 0;
    for (long x = 0; x < 48; x += 3) {
        const std::string text = explain_pixel(request, x, 18);
        const bool plane = frame.at(x, 18).object == 1;
        planes += plane ? 1 : 0;
        EXPECT_EQ(text.find("plane floor at ") != std::string::npos, plane) << x;
    }
    EXPECT_GT(planes, 2);
    EXPECT_LT(planes, 14);
}

TEST(Floor, a_plane_beyond_all_numbers_is_an_error) {
    EXPECT_EQ(test::error_of([] {
                  try {
                      (void)compile_text("plane p { point: 0,1e200,0 normal: 0,1,0 }");
                  } catch (const std::exception& error) {
                      throw Error(ErrorKind::scene, error.what());
                  }
              }),
              "3: test.pxm:1:1: error: plane \"p\" is too far away: its point lies beyond 1e+100\n"
              "    plane p { point: 0,1e200,0 normal: 0,1,0 }\n"
              "    ^");
    // Long and short normals are directions all the same.
    const CompiledScene scene =
        compile_text("plane { normal: 0,1e300,0 } plane { normal: 0,0,1e-300 }");
    EXPECT_EQ(scene.planes.at(0).normal.y, 1);
    EXPECT_EQ(scene.planes.at(1).normal.z, 1);
}

TEST(Floor, an_ifs_that_is_a_texture_is_no_object_by_default) {
    EXPECT_EQ(compile_text(gasket + "texture g { ifs: gasket }" + floor_block).objects.size(), 0U);
    EXPECT_EQ(compile_text(gasket + floor_block).objects.size(), 1U);
}

TEST(TextureFile, is_looked_for_beside_the_file_that_names_it) {
    const Folder folder;
    std::filesystem::create_directory(folder.path("room"));
    test::write_picture(folder.path("room/t.png"), 2, 2,
                        [](long, long) { return glm::dvec3{0.5}; });
    folder.write("room/floor.pxm",
                 "texture t { file: \"t.png\" } plane { normal: 0,1,0 texture: t }");
    folder.write("scene.pxm", "include: \"room/floor.pxm\"\nimage { size: 4,4 }");
    EXPECT_EQ(error_of(folder.path("scene.pxm")), "");
}

TEST(TextureFile, that_cannot_be_used_is_told_with_its_place_and_name) {
    const Folder folder;
    folder.write("text.png", "no picture\n");
    folder.write("empty.png", "");
    std::filesystem::create_directory(folder.path("folder"));
    const auto error = [&](const std::string& file) {
        folder.write("scene.pxm", "plane { normal: 0,1,0 texture: t }\ntexture t { file: \"" +
                                      file + "\" } image { size: 4,4 }");
        return error_of(folder.path("scene.pxm"));
    };
    for (const char* file : {"none.png", "text.png", "empty.png", "folder", "scene.pxm"}) {
        const std::string told = error(file);
        EXPECT_TRUE(told.starts_with(fmt::format("4: {}:2:19: texture \"t\": cannot read {}: ",
                                                 folder.path("scene.pxm"), folder.path(file))))
            << told;
        EXPECT_EQ(std::ranges::count(told, '\n'), 0) << told;
    }
}

TEST(TextureFile, of_a_texture_that_no_plane_has_is_not_read) {
    EXPECT_EQ(compile_text("texture t { file: \"none.png\" }" + floor_block).textures.size(), 0U);
}

TEST(TextureFile, in_two_planes_is_kept_once) {
    const Folder folder;
    test::write_picture(folder.path("t.png"), 4, 4, [](long, long) { return glm::dvec3{0.5}; });
    const CompiledScene scene = compile_text(
        fmt::format("texture t {{ file: \"{}\" }} plane {{ normal: 0,1,0 texture: t, t }} "
                    "plane {{ normal: 1,0,0 texture: t }}",
                    folder.path("t.png")));
    EXPECT_EQ(scene.texture_words.size(), 16U + 4 + 1);
}

TEST(TextureFile, of_grey_is_grey_and_sRGB_is_decoded) {
    const Folder folder;
    folder.write("grey.pgm", std::string("P5 1 1 255\n") + '\x80');
    ImageReader reader(folder.path("grey.pgm"), kept_image);
    const LinearPicture picture = read_linear_picture(reader);
    EXPECT_NEAR(picture.pixels.at(0)[0], 0.2158605, 1e-6);
    EXPECT_EQ(picture.pixels.at(0)[0], picture.pixels.at(0)[2]);
    for (float x = 0; x <= 1; x += 0.03125F) {
        EXPECT_NEAR(linear_from_srgb(srgb_from_linear(x)), x, 1e-6);
    }
}

TEST(TextureFile, of_a_pipe_is_refused_and_not_waited_for) {
    const Folder folder;
    ASSERT_EQ(mkfifo(folder.path("f.png").c_str(), 0666), 0);
    folder.write("scene.pxm",
                 "texture t { file: \"f.png\" } plane { normal: 0,1,0 texture: t }\n"
                 "image { size: 4,4 }");
    EXPECT_EQ(error_of(folder.path("scene.pxm")),
              fmt::format("4: {}:1:19: texture \"t\": cannot read {}: not a regular file",
                          folder.path("scene.pxm"), folder.path("f.png")));
}

TEST(TextureFile, there_are_so_many_of_them_at_most) {
    const Folder folder;
    test::write_picture(folder.path("t.png"), 1, 1, [](long, long) { return glm::dvec3{0.5}; });
    std::string text = "image { size: 4,4 }\n";
    for (std::size_t i = 0; i <= pictures_a_scene; ++i)
        text += fmt::format(
            "texture t{0} {{ file: \"t.png\" }} plane {{ normal: 0,1,0 texture: t{0} }}\n", i);
    folder.write("scene.pxm", text);
    EXPECT_EQ(error_of(folder.path("scene.pxm")),
              fmt::format("3: {}:258:22: texture \"t256\": a scene has at most 256 pictures",
                          folder.path("scene.pxm")));
}

TEST(TextureMemory, that_is_too_small_is_a_fault_of_the_machine_only) {
    const Folder folder;
    const auto scene = [&](int side) {
        test::write_picture(folder.path("t.png"), side, side,
                            [](long, long) { return glm::dvec3{0.5}; });
        folder.write("scene.pxm",
                     "texture t { file: \"t.png\" } plane { normal: 0,1,0 texture: t }\n"
                     "image { size: 8,8 }");
        return folder.path("scene.pxm");
    };
    // 182^2 and all smaller sizes are more than 128 KiB, 4 bytes a texel; 156^2 are less.
    EXPECT_EQ(error_of(scene(182), test::on_machine("964dX", 8, 8)),
              "5: the texture of node 0 of the 964dX is too small: 176260 bytes wanted, "
              "131072 there");
    EXPECT_EQ(error_of(scene(182)), "");
    RenderRequest request = test::on_machine("964dX", 8, 8);
    request.scene_path = scene(156);
    const MachineStatistics machine = *render(request, {}).statistics.machine;
    EXPECT_EQ(machine.texture.used_bytes,
              4 * (156 * 156 + 78 * 78 + 39 * 39 + 19 * 19 + 81 + 16 + 4 + 1));
    const auto reads = static_cast<std::size_t>(Operation::texture_scattered);
    EXPECT_GT(machine.tally.counts[reads], 0U);
}

std::string modules_of(const std::string& text) {
    std::string names;
    for (const ProgramModule& module : link(compile_text(text)).modules) {
        if (module.name.starts_with("texture") || module.name == "plane") {
            names += module.name + " ";
        }
    }
    return names;
}

TEST(FloorProgram, has_only_the_textures_that_planes_have) {
    const Folder folder;
    test::write_picture(folder.path("t.png"), 4, 4, [](long, long) { return glm::dvec3{0.5}; });
    const std::string textures = gasket + fmt::format(
                                              "texture w {{ wood }} texture g {{ ifs: gasket }} "
                                              "texture p {{ file: \"{}\" }} ",
                                              folder.path("t.png"));
    const auto floor = [](const std::string& names) {
        return fmt::format("plane {{ normal: 0,1,0 texture: {} }}", names);
    };
    EXPECT_EQ(modules_of(solid + textures), "");
    EXPECT_EQ(modules_of(solid + textures + floor_block), "plane ");
    EXPECT_EQ(modules_of(textures + floor("w")), "plane texture texture_wood ");
    EXPECT_EQ(modules_of(textures + floor("g")), "plane texture texture_inclusion ");
    EXPECT_EQ(modules_of(textures + floor("p")), "plane texture texture_image ");
    EXPECT_EQ(modules_of(textures + floor("w, g, p")),
              "plane texture texture_image texture_wood texture_inclusion ");
}

}  // namespace
}  // namespace pxm::host
