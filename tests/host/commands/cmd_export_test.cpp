// Laws of `pxm export`, by readers of its files that know nothing of how they are written.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "tests/support/command.hpp"
#include "tests/support/exported_mesh.hpp"

namespace pxm::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// Menger's sponge in the cube [-1,1]^3, 20 maps.
std::string menger_scene() {
    std::string text = "ifs menger {\n";
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z)
                if ((x == 0) + (y == 0) + (z == 0) < 2)
                    text +=
                        fmt::format("newmap scale: 1/3 translate: {}*2/3,{}*2/3,{}*2/3\n", x, y, z);
    return text + "}\nobject sponge { ifs: menger box: (-1,-1,-1)(1,1,1) }\n";
}

/// Four maps that turn, one that mirrors; boxes for cells.
const char* const turning =
    "ifs a {\n"
    "newmap scale: 0.5 rotate: z,30 translate: 1,0,0\n"
    "newmap scale: 0.4 rotate: x,75 translate: 0,1,0 color: 1,0,0,0.5\n"
    "newmap scale: -0.5,0.5,0.5 rotate: y,10 translate: 0,0,1 }\n"
    "object a { ifs: a box: (-3,-3,-3)(3,3,3) rotate: y,20 translate: 0,0,5 }\n";

/// Stretches and turns: cells are sheared.
const char* const shearing =
    "ifs a {\n"
    "newmap scale: 0.5,0.25,0.5 rotate: z,30 translate: 1,0,0\n"
    "newmap scale: 0.4 rotate: x,75 translate: 0,1,0\n"
    "newmap scale: -0.5,0.3,0.5 translate: 0,0,1 color: 0,1,0,1 }\n"
    "object a { ifs: a box: (-3,-3,-3)(3,3,3) }\n";

/// Two sets that lead to one another: triangles of Robinson's kind would do as well.
const char* const recurrent =
    "ifs a {\n"
    "newmap p scale: 0.5\n"
    "newmap q scale: 0.5 translate: 0.5,0,0\n"
    "newmap r scale: 0.5 translate: 0,0.5,0\n"
    "follow: p -> p, q\n follow: q -> q, r\n follow: r -> p, r\n }\n"
    "object a { ifs: a }\n";

class Export : public testing::Test {
  protected:
    Export() {
        folder.write("menger.pxm", menger_scene());
        folder.write("turning.pxm", turning);
        folder.write("shearing.pxm", shearing);
        folder.write("recurrent.pxm", recurrent);
    }
    std::string write(const std::string& scene, const std::string& out,
                      const Arguments& more = {"--levels", "2"}) {
        Arguments arguments{"export", scene, "-o", out, "--quiet"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return expect_done(folder, arguments);
    }
    Triangles triangles(const std::string& name) {
        const std::string bytes = folder.read(name);
        if (name.ends_with(".ply")) return triangles_of_ply(bytes);
        if (name.ends_with(".obj")) return triangles_of_obj(bytes);
        if (name.ends_with(".stl")) return triangles_of_stl(bytes);
        if (name.ends_with(".gltf"))
            return triangles_of_gltf(bytes, folder.read(name.substr(0, name.size() - 4) + "bin"));
        return triangles_of_gltf(bytes);
    }
    Folder folder;
};

const char* const mesh_files[] = {"a.ply", "a.obj", "a.stl", "a.glb", "a.gltf"};

TEST_F(Export, a_sponge_has_its_cubes_closed_outward_in_its_box_and_of_its_volume) {
    for (const char* file : mesh_files) {
        EXPECT_EQ(write("menger.pxm", file),
                  fmt::format("{}: 400 cells of 4800 triangles in all, 2 x 2 x 2\n", file));
        const Triangles all = triangles(file);
        EXPECT_EQ(all.size(), 400U * 12) << file;
        EXPECT_TRUE(has_no_rim({all.begin(), all.begin() + 12})) << file;
        EXPECT_NEAR(inside_of(all), 8 * std::pow(20.0 / 27, 2), 1e-5) << file;
        const Extent box = extent_of(all);
        for (int k = 0; k < 3; ++k) {
            EXPECT_NEAR(box.low[k], -1, 1e-6) << file;
            EXPECT_NEAR(box.high[k], 1, 1e-6) << file;
        }
    }
}

/// What turning, mirroring and shearing makes of the boxes' volume: the sum of |det| over words.
TEST_F(Export, cells_of_any_maps_look_outward) {
    const double turned = 0.125 + 0.064 + 0.125;
    const double sheared = 0.5 * 0.25 * 0.5 + 0.064 + 0.5 * 0.3 * 0.5;
    for (const char* file : mesh_files) {
        for (const auto& [scene, share] :
             {std::pair{"turning.pxm", turned}, std::pair{"shearing.pxm", sheared}}) {
            (void)write(scene, file);
            const Triangles all = triangles(file);
            ASSERT_EQ(all.size(), 9U * 12) << file;
            for (std::size_t i = 0; i < 9; ++i) {
                const Triangles cell(all.begin() + 12 * static_cast<long>(i),
                                     all.begin() + 12 * static_cast<long>(i + 1));
                EXPECT_TRUE(std::string(file).ends_with("b") || has_no_rim(cell)) << file << i;
                EXPECT_GT(inside_of(cell), 0) << file << scene << i;
            }
            EXPECT_NEAR(inside_of(all) / (216 * share * share), 1, 1e-5) << file << scene;
        }
    }
}

/// One shape in three axes: z turned over, or y and z exchanged, is a mirror image in numbers and
/// the same solid in space.
TEST_F(Export, formats_have_their_axes) {
    for (const char* file : mesh_files) (void)write("turning.pxm", file);
    const Triangles own = triangles("a.ply");
    const auto same = [&](const char* file, const auto& back) {
        const Extent a = extent_of(own);
        Triangles other = triangles(file);
        for (Triangle& triangle : other)
            for (glm::dvec3& v : triangle) v = back(v);
        const Extent b = extent_of(other);
        EXPECT_LT(glm::distance(a.low, b.low) + glm::distance(a.high, b.high), 1e-4) << file;
        EXPECT_LT(inside_of(other), 0) << file;
    };
    for (const char* file : {"a.obj", "a.glb", "a.gltf"})
        same(file, [](const glm::dvec3& v) { return glm::dvec3{v.x, v.y, -v.z}; });
    same("a.stl", [](const glm::dvec3& v) { return glm::dvec3{v.x, v.z, v.y}; });
}

TEST_F(Export, instances_are_written_where_cells_are_turned_and_geometry_where_they_are_sheared) {
    EXPECT_THAT(write("turning.pxm", "a.glb"), Not(HasSubstr("sheared")));
    EXPECT_THAT(folder.read("a.glb"),
                HasSubstr("\"extensionsRequired\":[\"EXT_mesh_gpu_instancing"));
    EXPECT_THAT(write("shearing.pxm", "a.glb"),
                HasSubstr("cells that are sheared are geometry, not instances\n"));
    EXPECT_THAT(folder.read("a.glb"), Not(HasSubstr("EXT_mesh_gpu_instancing")));
    EXPECT_THAT(folder.read("a.glb"), HasSubstr("COLOR_0"));
}

/// three.js, for one, turns no faces of mirrored instances over
/// (findings/three_mirrored_instance.sh).
TEST_F(Export, instances_that_mirror_are_seen_from_both_sides) {
    (void)write("turning.pxm", "a.glb");
    EXPECT_THAT(folder.read("a.glb"), HasSubstr("\"doubleSided\":true"));
    (void)write("menger.pxm", "a.glb");
    EXPECT_THAT(folder.read("a.glb"), Not(HasSubstr("doubleSided")));
}

/// For programs that know no instances: the same triangles.
TEST_F(Export, geometry_is_written_where_it_is_asked_for) {
    for (const char* file : {"a.glb", "a.gltf"}) {
        (void)write("turning.pxm", file);
        const Triangles instances = triangles(file);
        (void)write("turning.pxm", file, {"--levels", "2", "--geometry"});
        EXPECT_THAT(folder.read(file), Not(HasSubstr("EXT_mesh_gpu_instancing")));
        const Triangles geometry = triangles(file);
        ASSERT_EQ(geometry.size(), instances.size());
        EXPECT_NEAR(inside_of(geometry), inside_of(instances), 1e-4);
        EXPECT_LT(glm::distance(extent_of(geometry).low, extent_of(instances).low), 1e-5);
        EXPECT_LT(glm::distance(extent_of(geometry).high, extent_of(instances).high), 1e-5);
    }
    expect_refusal(folder, {"export", "turning.pxm", "-o", "b.ply", "--levels", "2", "--geometry"},
                   2, "--geometry is for glb and gltf, not for ply");
}

/// Readers of OBJ take colours for sRGB: 0.5 of red on the base colour of 0.9.
TEST_F(Export, colours_of_an_obj_are_srgb) {
    (void)write("turning.pxm", "a.obj", {"--levels", "1"});
    EXPECT_THAT(folder.read("a.obj"), HasSubstr(" 0.9777 0.7014 0.7014\n"));
}

TEST_F(Export, usd_has_an_instancer_or_a_prim_a_cell) {
    (void)write("turning.pxm", "a.usda");
    const std::string instancer = folder.read("a.usda");
    EXPECT_THAT(instancer, testing::StartsWith("#usda 1.0\n"));
    const auto values_of = [&](const std::string& name) {
        const std::size_t begin = instancer.find(name + " = [");
        const std::string list = instancer.substr(begin, instancer.find('\n', begin) - begin);
        return std::ranges::count(list, '(') +
               (name.starts_with("int") ? std::ranges::count(list, ',') + 1 : 0);
    };
    EXPECT_EQ(values_of("int[] protoIndices"), 9);
    EXPECT_EQ(values_of("point3f[] positions"), 9);
    EXPECT_EQ(values_of("quath[] orientations"), 9);
    EXPECT_EQ(values_of("float3[] scales"), 9);
    (void)write("shearing.pxm", "b.usda");
    const std::string prims = folder.read("b.usda");
    std::size_t count = 0;
    for (std::size_t at = 0;
         (at = prims.find("matrix4d xformOp:transform", at + 1)) != std::string::npos;)
        ++count;
    EXPECT_EQ(count, 9U);
    EXPECT_EQ(std::ranges::count(prims, '{'), std::ranges::count(prims, '}'));
}

TEST_F(Export, a_recurrent_system_has_the_words_that_may_follow) {
    EXPECT_THAT(write("recurrent.pxm", "a.ply", {"--levels", "4", "--shape", "box"}),
                HasSubstr("24 cells"));  // 3 first maps, 2 after each
    EXPECT_THAT(write("recurrent.pxm", "b.ply", {"--levels", "0", "--shape", "box"}),
                HasSubstr("1 cells"));
}

TEST_F(Export, cells_end_at_the_level_or_at_the_length) {
    folder.write("uneven.pxm",
                 "ifs a { newmap scale: 0.5 newmap scale: 0.25 translate: 1,0,0 }\n"
                 "object a { ifs: a box: (-2,-2,-2)(2,2,2) }\n");
    const double diagonal = 4 * std::sqrt(3.0);
    // 1/2 ends at once; then 1/4 of the words of one map each way.
    EXPECT_THAT(write("uneven.pxm", "a.ply", {"--detail", fmt::format("{}", 0.51 * diagonal)}),
                HasSubstr("2 cells"));
    EXPECT_THAT(write("uneven.pxm", "a.ply", {"--detail", fmt::format("{}", 0.26 * diagonal)}),
                HasSubstr("3 cells"));
    EXPECT_THAT(write("uneven.pxm", "a.ply",
                      {"--detail", fmt::format("{}", 0.01 * diagonal), "--levels", "1"}),
                HasSubstr("2 cells"));
    folder.write("says.pxm",
                 "ifs a { newmap scale: 0.5 newmap scale: 0.25 translate: 1,0,0 }\n"
                 "object a { ifs: a levels: 3 }\nobject ball { sphere: (0,0,0) 1 }\n");
    EXPECT_THAT(write("says.pxm", "a.ply", {}), HasSubstr("9 cells"));
}

TEST_F(Export, shapes_are_the_volumes_or_a_mesh_of_the_users) {
    const auto count = [&](const char* shape) {
        (void)write("menger.pxm", "s.stl", {"--levels", "0", "--shape", shape});
        return triangles("s.stl").size();
    };
    EXPECT_EQ(count("ball"), 80U);
    EXPECT_EQ(count("box"), 12U);
    EXPECT_EQ(count("oriented"), 12U);
    EXPECT_GE(count("hull"), 12U);
    folder.write("tetra.obj",
                 "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    (void)write("menger.pxm", "m.stl", {"--levels", "1", "--shape", folder.path("tetra.obj")});
    EXPECT_EQ(triangles("m.stl").size(), 80U);
    EXPECT_NEAR(inside_of(triangles("m.stl")), 20.0 / 27 / 6, 1e-6);
}

TEST_F(Export, lengths_are_scaled_and_the_scale_is_stated) {
    (void)write("menger.pxm", "a.stl", {"--levels", "1", "--scale", "20"});
    EXPECT_NEAR(extent_of(triangles("a.stl")).high.x, 20, 1e-4);
    EXPECT_THAT(folder.read("a.stl").substr(0, 80), HasSubstr("1 = 0.05 of the scene"));
    EXPECT_THAT(folder.read("a.stl"), Not(testing::StartsWith("solid")));
}

TEST_F(Export, povray_has_a_union_a_level_whatever_the_cells) {
    EXPECT_THAT(write("menger.pxm", "a.pov", {"--levels", "30"}),
                HasSubstr("POV-Ray makes 1.07374e+39 objects of it"));
    const std::string text = folder.read("a.pov");
    EXPECT_LT(text.size(), 100'000U);
    EXPECT_THAT(text, HasSubstr("#declare pxm_1_1_30 = union {"));
    EXPECT_THAT(text, HasSubstr("#declare pxm_1_1_0 = box { <-1, -1, -1>, <1, 1, 1> }"));
}

TEST_F(Export, far_small_cells_are_doubles_or_refused) {
    folder.write("far.pxm",
                 "ifs a { newmap scale: 0.5 newmap scale: 0.5 translate: 0.5,0,0 }\n"
                 "object a { ifs: a translate: 1000000,0,0 }\n");
    (void)write("far.pxm", "a.ply", {"--levels", "6", "--shape", "box"});
    EXPECT_THAT(folder.read("a.ply"), HasSubstr("property double x"));
    std::filesystem::remove(folder.path("a.ply"));
    for (const char* out : {"a.stl", "a.glb", "a.usda"})
        expect_refusal_naming(folder,
                              {"export", "far.pxm", "-o", out, "--levels", "6", "--shape", "box"},
                              2, {"too far from the origin"});
}

TEST_F(Export, what_a_format_cannot_hold_is_refused_before_anything_is_written) {
    expect_refusal_naming(folder, {"export", "menger.pxm", "-o", "a.ply"}, 2,
                          {"object \"sponge\" does not say where it ends: --levels N or --detail"});
    for (const auto& [out, message] :
         {std::pair{"a.ply", "the numbers of a PLY mesh end at 4294967295"},
          std::pair{"a.stl", "STL counts to 4294967295"},
          std::pair{"a.glb", "a .glb holds 4 GiB at most; --format gltf holds more"}})
        expect_refusal_naming(folder, {"export", "menger.pxm", "-o", out, "--levels", "900"}, 2,
                              {message});
    expect_refusal_naming(folder, {"export", "menger.pxm", "-o", "a.png"}, 2,
                          {"a.png: its extension names no format"});
    expect_refusal_naming(folder, {"export", "menger.pxm", "-o", "a", "--format", "x"}, 2,
                          {"--format"});
    expect_refusal_naming(folder, {"export", "menger.pxm", "-o", "a.ply", "--shape", "cow"}, 2,
                          {"--shape cow: expected auto, ball, box, oriented, hull, or a mesh"});
    expect_refusal(folder,
                   {"export", "menger.pxm", "-o", "a.ply", "--levels", "1", "--voxels", "9"}, 2,
                   "--voxels is for vdb, not for ply");
    expect_refusal(
        folder, {"export", "menger.pxm", "-o", "a.vdb", "--levels", "1", "--shape", "t.obj"}, 2,
        "--shape: a level set is one of volumes: expected auto, ball, box, oriented or hull");
    expect_refusal_naming(folder, {"export", "menger.pxm", "-o", "a.aifs", "--levels", "2"}, 2,
                          {"--levels says nothing to aifs"});
    expect_refusal_naming(folder, {"export", "menger.pxm", "-o", "a.flame"}, 3,
                          {"object \"sponge\" is not of the plane z = 0"});
    expect_refusal_naming(folder, {"export", "menger.pxm", "-o", "a.obj", "--levels", "60"}, 2,
                          {"object \"sponge\" has more than 1000000000 cells"});
    expect_refusal_naming(folder, {"export", "none.pxm", "-o", "a.ply", "--levels", "2"}, 4, {});
    expect_refusal_naming(folder, {"export", "menger.pxm", "-o", "no/a.ply", "--levels", "2"}, 4,
                          {"no/a.ply"});
    expect_refusal_naming(
        folder, {"export", "menger.pxm", "-o", "/dev/null", "--format", "gltf", "--levels", "1"}, 2,
        {"--format glb is one file"});
}

TEST_F(Export, nothing_that_is_read_is_written_over) {
    std::filesystem::create_hard_link(folder.path("menger.pxm"), folder.path("link.bin"));
    std::filesystem::create_hard_link(folder.path("menger.pxm"), folder.path("link.ply"));
    expect_refusal(folder, {"export", "menger.pxm", "-o", "link.ply", "--levels", "1"}, 2,
                   "link.ply would be written over the scene");
    expect_refusal(folder, {"export", "menger.pxm", "-o", "link.gltf", "--levels", "1"}, 2,
                   "link.bin would be written over the scene");
    folder.write("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    expect_refusal_naming(
        folder, {"export", "menger.pxm", "-o", "t.obj", "--levels", "1", "--shape", "t.obj"}, 2,
        {"t.obj would be written over the mesh of --shape"});
}

TEST_F(Export, a_device_is_written_through) {
    for (const char* format : {"ply", "glb", "stl", "obj", "usda", "pov", "aifs"}) {
        Arguments arguments{"export", "menger.pxm", "-o", "/dev/null", "--format", format};
        if (std::string(format) != "aifs") arguments.insert(arguments.end(), {"--levels", "1"});
        EXPECT_EQ(run(folder, arguments).exit_code, 0) << format;
    }
    for (const char* format : {"ply", "glb", "pov"})
        EXPECT_EQ(run(folder, {"export", "menger.pxm", "-o", "/dev/full", "--format", format,
                               "--levels", "1"})
                      .exit_code,
                  4)
            << format;
}

/// Pictures of both scenes, byte by byte.
void expect_same_picture(Folder& folder, const std::string& a, const std::string& b) {
    for (const auto& [scene, out] : {std::pair{a, "a.png"}, std::pair{b, "b.png"}})
        (void)expect_done(folder,
                          {"render", scene, "-o", out, "--size", "80x60", "--quiet", "--no-scene"});
    EXPECT_EQ(folder.read("a.png").size(), folder.read("b.png").size()) << a;
    EXPECT_TRUE(folder.read("a.png") == folder.read("b.png")) << a;
}

TEST_F(Export, a_scene_comes_back_from_aifs_as_the_same_picture) {
    folder.write("solid.pxm",
                 "ifs a { newmap scale: 0.5 rotate: y,20 newmap scale: 0.4,0.5,0.3 rotate: x,40 "
                 "translate: 0.5,0.7,1/3\nnewmap scale: -0.3,0.3,0.3 translate: -1/7,0,0.2 }\n"
                 "camera { eye: 1,2,-5 look: 0.3,0.2,0.1 fov: 33 }\n");
    for (const char* scene : {"menger.pxm", "recurrent.pxm", "solid.pxm"}) {
        // What AIFS does not hold is not part of the comparison.
        const std::string text = folder.read(scene);
        folder.write("plain.pxm", text.substr(0, text.find("object")));
        EXPECT_THAT(write("plain.pxm", "x.aifs", {}), IsEmpty());
        (void)expect_done(folder, {"import", "x.aifs", "-o", "back.pxm"});
        expect_same_picture(folder, "plain.pxm", "back.pxm");
    }
}

/// A scene of the plane that was imported keeps its two dimensions.
TEST_F(Export, an_imported_plane_scene_comes_back_from_aifs_as_the_same_picture) {
    folder.write("gasket.ifs",
                 "gasket {\n.5 0 0 .5 0 0 .33\n.5 0 0 .5 1 0 .33\n0 -.5 .5 0 .5 1 .34\n}\n");
    (void)expect_done(folder, {"import", "gasket.ifs", "-o", "plane.pxm"});
    (void)write("plane.pxm", "x.aifs", {});
    EXPECT_THAT(folder.read("x.aifs"), HasSubstr("$dim=2\n"));
    (void)expect_done(folder, {"import", "x.aifs", "-o", "back.pxm"});
    expect_same_picture(folder, "plane.pxm", "back.pxm");
}

TEST_F(Export, a_plane_scene_comes_back_from_a_flame_as_the_same_picture) {
    folder.write("fern.ifs",
                 "fern {\n0 0 0 .16 0 0 .01\n.85 .04 -.04 .85 0 1.6 .85\n"
                 ".2 -.26 .23 .22 0 1.6 .07\n-.15 .28 .26 .24 0 .44 .07\n}\n");
    (void)expect_done(folder, {"import", "fern.ifs", "-o", "fern.pxm"});
    folder.write("xaos.flame",
                 "<flame name=\"x\" size=\"80 60\" center=\"0.3 -0.4\" scale=\"37\">\n"
                 "<xform weight=\"1\" linear=\"1\" coefs=\"0.5 0.1 0 0.5 0 0\" color=\"0\" "
                 "chaos=\"1 1 0\"/>\n"
                 "<xform weight=\"2\" linear=\"1\" coefs=\"0.5 0 0.2 0.5 0.5 0\" color=\"0.5\"/>\n"
                 "<xform weight=\"1\" linear=\"1\" coefs=\"0.5 0 0 -0.5 0 -0.5\" color=\"1\" "
                 "opacity=\"0\"/>\n"
                 "<finalxform linear=\"1\" coefs=\"0.8 0.1 -0.1 0.8 0.1 0\"/>\n"
                 "<color index=\"0\" rgb=\"255 80 0\"/><color index=\"128\" rgb=\"9 200 30\"/>"
                 "<color index=\"255\" rgb=\"0 80 255\"/>\n</flame>\n");
    (void)expect_done(folder, {"import", "xaos.flame", "-o", "xaos.pxm"});
    for (const char* scene : {"fern.pxm", "xaos.pxm"}) {
        EXPECT_THAT(write(scene, "x.flame", {}), IsEmpty());
        (void)expect_done(folder, {"import", "x.flame", "-o", "back.pxm"});
        expect_same_picture(folder, scene, "back.pxm");
    }
}

TEST_F(Export, two_runs_make_the_same_bytes) {
    for (const char* file : {"ply", "obj", "stl", "glb", "usda", "pov", "aifs"}) {
        Arguments more;
        if (std::string(file) != "aifs") more = {"--levels", "2"};
        (void)write("turning.pxm", fmt::format("1.{}", file), more);
        (void)write("turning.pxm", fmt::format("2.{}", file), more);
        EXPECT_TRUE(folder.read(fmt::format("1.{}", file)) ==
                    folder.read(fmt::format("2.{}", file)))
            << file;
    }
}

}  // namespace
}  // namespace pxm::test
