// Laws of `pxm export`: what stands in the files, read by a few lines of this test's own.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/command.hpp"

namespace pxm::test {
namespace {

using testing::HasSubstr;

// Twenty cubes in a cube (Menger), a mirrored and squashed object of the same, and a cube alone.
std::string cubes_scene() {
    std::string maps;
    for (int i = 0; i < 27; ++i) {
        const int x = i % 3 - 1, y = i / 3 % 3 - 1, z = i / 9 - 1;
        if ((x == 0) + (y == 0) + (z == 0) > 1) continue;
        maps += fmt::format("newmap scale: 1/3 translate: {}*2/3,{}*2/3,{}*2/3\n", x, y, z);
    }
    return "ifs cubes {\n" + maps +
           "}\n"
           "object near { ifs: cubes box: (-1,-1,-1)(1,1,1) color: 1,0,0,1 }\n"
           "object far { ifs: cubes box: (-1,-1,-1)(1,1,1) scale: -1,2,0.5 translate: 4,0,0 }\n"
           "object alone { box translate: 0,5,0 }\n";
}
constexpr std::size_t cubes_at_two = 400 + 400 + 1;
// Of each cell (2/9)^3 times what its object is scaled by, and of the cube alone.
const double volume_at_two = 400 * std::pow(2.0 / 9, 3) * (1 + 1) + 8;

class Export : public testing::Test {
  protected:
    Export() {
        folder.write("cubes.pxm", cubes_scene());
        folder.write("tetra.pxm", tetra_scene);
    }
    std::string exported(const std::string& file, std::vector<std::string> more = {}) {
        std::vector<std::string> arguments{"export", "cubes.pxm", "-o", file};
        if (more.empty()) more = {"--levels", "2"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        expect_done(folder, arguments);
        return folder.read(file);
    }
    Folder folder;
};

struct Triangles {
    std::vector<glm::dvec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> corners;
};

template <class Value>
Value take(const std::string& bytes, std::size_t& at) {
    Value value{};
    EXPECT_LE(at + sizeof value, bytes.size());
    std::memcpy(&value, bytes.data() + at, sizeof value);
    at += sizeof value;
    return value;
}
glm::dvec3 take_point(const std::string& bytes, std::size_t& at) {
    const auto x = take<float>(bytes, at), y = take<float>(bytes, at), z = take<float>(bytes, at);
    return {x, y, z};
}

double volume_of(const Triangles& mesh) {
    double sum = 0;
    for (const auto& [a, b, c] : mesh.corners)
        sum += glm::dot(mesh.vertices[a], glm::cross(mesh.vertices[b], mesh.vertices[c])) / 6;
    return sum;
}

void expect_cubes(const Triangles& mesh) {
    EXPECT_EQ(mesh.corners.size(), 12 * cubes_at_two);
    EXPECT_NEAR(volume_of(mesh), volume_at_two, 1e-4);
    glm::dvec3 low{1e9}, high{-1e9};
    for (const glm::dvec3& vertex : mesh.vertices) {
        low = glm::min(low, vertex);
        high = glm::max(high, vertex);
    }
    EXPECT_LT(glm::distance(low, glm::dvec3{-1, -2, -1}), 1e-6);
    EXPECT_LT(glm::distance(high, glm::dvec3{5, 6, 1}), 1e-6);
    std::map<std::array<std::uint32_t, 2>, int> edges;
    for (const auto& t : mesh.corners)
        for (std::size_t i = 0; i < 3; ++i) ++edges[{t[i], t[(i + 1) % 3]}];
    for (const auto& [edge, count] : edges) {
        ASSERT_EQ(count, 1);
        ASSERT_EQ(edges.count({edge[1], edge[0]}), 1U) << "the mesh is open";
    }
}

TEST_F(Export, a_ply_has_closed_cubes_turned_outward_with_their_colours) {
    const std::string ply = exported("a.ply");
    std::size_t at = ply.find("end_header\n") + 11;
    EXPECT_THAT(ply, HasSubstr(fmt::format("element vertex {}\n", 8 * cubes_at_two)));
    Triangles mesh;
    for (std::size_t i = 0; i < 8 * cubes_at_two; ++i) {
        mesh.vertices.push_back(take_point(ply, at));
        const auto color = take<std::array<unsigned char, 3>>(ply, at);
        const bool is_red = i < 8 * 400;
        EXPECT_EQ(int{color[1]}, is_red ? 0 : int{color[0]});
    }
    for (std::size_t i = 0; i < 12 * cubes_at_two; ++i) {
        EXPECT_EQ(int{take<unsigned char>(ply, at)}, 3);
        mesh.corners.push_back(take<std::array<std::uint32_t, 3>>(ply, at));
    }
    EXPECT_EQ(at, ply.size());
    expect_cubes(mesh);
}

TEST_F(Export, an_obj_has_the_same) {
    Triangles mesh;
    std::string obj = exported("a.obj");
    for (std::size_t at = 0; at < obj.size(); at = obj.find('\n', at) + 1) {
        double x = 0, y = 0, z = 0;
        unsigned a = 0, b = 0, c = 0;
        if (std::sscanf(&obj[at], "v %lf %lf %lf", &x, &y, &z) == 3)
            mesh.vertices.emplace_back(x, y, z);
        if (std::sscanf(&obj[at], "f %u %u %u", &a, &b, &c) == 3)
            mesh.corners.push_back({a - 1, b - 1, c - 1});
    }
    EXPECT_EQ(mesh.vertices.size(), 8 * cubes_at_two);
    expect_cubes(mesh);
    EXPECT_THAT(obj, HasSubstr("\no alone\n"));
}

TEST_F(Export, an_stl_has_outward_normals_and_the_scale_asked_for) {
    const std::string stl = exported("a.stl", {"--levels", "2", "--scale", "10"});
    std::size_t at = 80;
    ASSERT_EQ(take<std::uint32_t>(stl, at), 12 * cubes_at_two);
    ASSERT_EQ(stl.size(), 84 + 50 * 12 * cubes_at_two);
    EXPECT_NE(stl.substr(0, 5), "solid");
    double volume = 0;
    while (at < stl.size()) {
        const glm::dvec3 normal = take_point(stl, at);
        const glm::dvec3 a = take_point(stl, at), b = take_point(stl, at), c = take_point(stl, at);
        const glm::dvec3 across = glm::cross(b - a, c - a);
        ASSERT_GT(glm::dot(normal, across), 0.999 * glm::length(across));
        volume += glm::dot(a, glm::cross(b, c)) / 6;
        at += 2;
    }
    EXPECT_NEAR(volume / 1000, volume_at_two, 1e-3);
}

struct Gltf {
    nlohmann::json json;
    std::string buffer;

    [[nodiscard]] std::vector<float> floats(int accessor, std::size_t each) const {
        const auto& of = json["accessors"][static_cast<std::size_t>(accessor)];
        std::size_t at = json["bufferViews"][of["bufferView"].get<std::size_t>()]["byteOffset"];
        std::vector<float> values(of["count"].get<std::size_t>() * each);
        for (float& value : values) value = take<float>(buffer, at);
        return values;
    }
};

Gltf gltf_of_glb(const std::string& glb) {
    std::size_t at = 0;
    EXPECT_EQ(take<std::uint32_t>(glb, at), 0x46546c67U);
    EXPECT_EQ(take<std::uint32_t>(glb, at), 2U);
    EXPECT_EQ(take<std::uint32_t>(glb, at), glb.size());
    const auto length = take<std::uint32_t>(glb, at);
    EXPECT_EQ(length % 4, 0U);
    EXPECT_EQ(take<std::uint32_t>(glb, at), 0x4e4f534aU);
    Gltf gltf{nlohmann::json::parse(glb.substr(at, length)), ""};
    at += length;
    const auto bytes = take<std::uint32_t>(glb, at);
    EXPECT_EQ(take<std::uint32_t>(glb, at), 0x004e4942U);
    gltf.buffer = glb.substr(at);
    EXPECT_EQ(gltf.buffer.size(), bytes);
    EXPECT_EQ(gltf.json["buffers"][0]["byteLength"], bytes);
    return gltf;
}

/// The cells of all instances as triangles: what a reader makes of the file.
Triangles triangles_of(const Gltf& gltf) {
    Triangles all;
    for (const auto& node : gltf.json["nodes"]) {
        if (!node.contains("mesh")) continue;
        const auto& part = gltf.json["meshes"][node["mesh"].get<std::size_t>()]["primitives"][0];
        const auto points = gltf.floats(part["attributes"]["POSITION"], 3);
        std::size_t at = 0;
        const auto& indices = gltf.json["accessors"][part["indices"].get<std::size_t>()];
        at = gltf.json["bufferViews"][indices["bufferView"].get<std::size_t>()]["byteOffset"];
        std::vector<std::uint32_t> corners(indices["count"].get<std::size_t>());
        for (std::uint32_t& corner : corners) corner = take<std::uint32_t>(gltf.buffer, at);
        const auto& places = node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
        const auto move = gltf.floats(places["TRANSLATION"], 3);
        const auto turn = gltf.floats(places["ROTATION"], 4);
        const auto scale = gltf.floats(places["SCALE"], 3);
        for (std::size_t i = 0; i < move.size() / 3; ++i) {
            const glm::dquat q(turn[4 * i + 3], turn[4 * i], turn[4 * i + 1], turn[4 * i + 2]);
            const glm::dvec3 s{scale[3 * i], scale[3 * i + 1], scale[3 * i + 2]};
            const auto first = static_cast<std::uint32_t>(all.vertices.size());
            for (std::size_t k = 0; k < points.size(); k += 3) {
                const glm::dvec3 vertex{points[k], points[k + 1], points[k + 2]};
                all.vertices.push_back(glm::dvec3{move[3 * i], move[3 * i + 1], move[3 * i + 2]} +
                                       q * (s * vertex));
            }
            // A mirrored instance's triangles are seen from their other side.
            const bool mirrored = s.x * s.y * s.z < 0;
            for (std::size_t k = 0; k < corners.size(); k += 3) {
                all.corners.push_back({first + corners[k], first + corners[k + (mirrored ? 2 : 1)],
                                       first + corners[k + (mirrored ? 1 : 2)]});
            }
        }
    }
    return all;
}

TEST_F(Export, a_glb_has_places_of_three_meshes_that_make_the_same_cubes) {
    const Gltf gltf = gltf_of_glb(exported("a.glb"));
    EXPECT_EQ(gltf.json["meshes"].size(), 3U);
    EXPECT_EQ(gltf.json["extensionsRequired"][0], "EXT_mesh_gpu_instancing");
    expect_cubes(triangles_of(gltf));
}

TEST_F(Export, a_gltf_has_the_numbers_of_the_glb_as_text) {
    const Gltf binary = gltf_of_glb(exported("a.glb"));
    const auto text = nlohmann::json::parse(exported("a.gltf"));
    const std::string uri = text["buffers"][0]["uri"];
    const std::string head = "data:application/octet-stream;base64,";
    ASSERT_EQ(uri.substr(0, head.size()), head);
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned bits = 0, count = 0;
    for (const char c : uri.substr(head.size())) {
        if (c == '=') break;
        bits = bits << 6U | static_cast<unsigned>(digits.find(c));
        if ((count += 6) < 8) continue;
        count -= 8;
        bytes += static_cast<char>(bits >> count & 255U);
    }
    EXPECT_TRUE(bytes == binary.buffer);
    EXPECT_EQ(text["accessors"], binary.json["accessors"]);
}

TEST_F(Export, turned_cells_are_instances_and_sheared_ones_are_triangles) {
    folder.write("turned.pxm",
                 "ifs a { newmap scale: 0.5 rotate: z,30 newmap scale: 0.4 rotate: x,70 translate: "
                 "1,0,0 }\nobject o { ifs: a box: (-3,-3,-3)(3,3,3) }\n");
    folder.write("sheared.pxm",
                 "ifs a { newmap scale: 0.5,0.3,0.5 rotate: z,30 newmap scale: 0.4 rotate: z,70 "
                 "translate: 1,0,0 }\nobject o { ifs: a box: (-3,-3,-3)(3,3,3) }\n");
    double volumes[2] = {0, 0};
    for (int i = 0; i < 2; ++i) {
        const std::string scene = i == 0 ? "turned.pxm" : "sheared.pxm";
        const std::string told = expect_done(
            folder, {"export", scene, "-o", "a.glb", "--levels", "3", "--volume", "box"});
        EXPECT_THAT(told, HasSubstr(i == 0 ? "8 cells as instances" : "8 cells as triangles"));
        const Gltf gltf = gltf_of_glb(folder.read("a.glb"));
        EXPECT_EQ(gltf.json.contains("extensionsRequired"), i == 0);
        if (i == 0) volumes[0] = volume_of(triangles_of(gltf));
        expect_done(folder, {"export", scene, "-o", "a.stl", "--levels", "3", "--volume", "box"});
        const std::string stl = folder.read("a.stl");
        double volume = 0;
        for (std::size_t at = 84; at < stl.size(); at += 2) {
            (void)take_point(stl, at);
            const glm::dvec3 a = take_point(stl, at), b = take_point(stl, at),
                             c = take_point(stl, at);
            volume += glm::dot(a, glm::cross(b, c)) / 6;
        }
        volumes[1] = volume;
        EXPECT_GT(volume, 0);
        if (i == 1) continue;
        EXPECT_NEAR(volumes[0], volumes[1], 1e-5 * volumes[1]);
    }
}

TEST_F(Export, a_usda_has_an_instancer_where_cells_are_only_moved_and_scaled) {
    const std::string usda = exported("a.usda");
    EXPECT_THAT(usda, HasSubstr("def PointInstancer \"object1_near\""));
    const std::size_t at = usda.find("int[] protoIndices = [");
    const std::string indices = usda.substr(at, usda.find(']', at + 22) - at);
    EXPECT_EQ(std::ranges::count(indices, ','), 399);
    EXPECT_THAT(exported("b.usda", {"--levels", "1", "--geometry"}),
                testing::Not(HasSubstr("PointInstancer")));
}

/// How many meshes POV-Ray would hold: each use of a name stands for all that it holds.
TEST_F(Export, a_pov_has_a_union_for_each_level_and_as_many_objects_as_cells) {
    const std::string pov = exported("a.pov", {"--levels", "4"});
    EXPECT_LT(pov.size(), 60'000U);
    std::map<std::string, std::uint64_t> held;
    std::string name;
    std::uint64_t all = 0;
    for (std::size_t at = 0; at < pov.size(); at = pov.find('\n', at) + 1) {
        const std::string line = pov.substr(at, pov.find('\n', at) - at);
        char word[64];
        if (std::sscanf(line.c_str(), "#declare %63s =", word) == 1) {
            name = word;
            if (line.find("mesh") != std::string::npos) held[name] = 1;
        } else if (std::sscanf(line.c_str(), "object { Object%63s", word) == 1) {
            const std::uint64_t inside = held.at("Object" + std::string(word));
            (line.find("pigment") != std::string::npos ? all : held[name]) += inside;
        }
    }
    EXPECT_EQ(all, 160'000U + 160'000 + 1);
    EXPECT_THAT(pov, HasSubstr("POV-Ray makes 320001 objects of it"));
}

TEST_F(Export, a_shape_of_ones_own_stands_for_each_cell) {
    folder.write("spike.obj",
                 "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    expect_done(folder,
                {"export", "tetra.pxm", "-o", "a.stl", "--levels", "3", "--shape", "spike.obj"});
    EXPECT_EQ(folder.read("a.stl").size(), 84 + 50 * 4 * 64U);
    folder.write("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 3 2\n");
    expect_refusal_naming(
        folder, {"export", "tetra.pxm", "-o", "b.stl", "--levels", "3", "--shape", "open.obj"}, 3,
        {"open.obj", "not closed"});
    expect_done(folder,
                {"export", "tetra.pxm", "-o", "b.ply", "--levels", "3", "--shape", "open.obj"});
}

TEST_F(Export, far_from_the_origin_the_digits_are_kept) {
    folder.write("far.pxm",
                 "ifs a { newmap scale: 0.5 translate: 5e8,0,0 newmap scale: 0.5 translate: "
                 "5e8+0.5,0,0 newmap scale: 0.5 translate: 5e8,0.5,0.5 }\nobject o { ifs: a }\n");
    const std::string told = expect_done(
        folder, {"export", "far.pxm", "-o", "a.ply", "--levels", "4", "--volume", "box"});
    EXPECT_THAT(told, HasSubstr("the file's origin is"));
    const std::string ply = folder.read("a.ply");
    std::size_t at = ply.find("end_header\n") + 11;
    for (int i = 0; i < 8; ++i) {
        EXPECT_LT(glm::length(take_point(ply, at)), 2);
        at += 3;
    }
}

TEST_F(Export, what_cannot_be_is_refused_and_leaves_no_file) {
    const auto refused = [&](std::vector<std::string> more, int code, const char* told) {
        std::vector<std::string> arguments{"export", "tetra.pxm"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        expect_refusal_naming(folder, arguments, code, {told});
    };
    refused({"-o", "a.ply"}, 2, "say --levels N or --detail LENGTH");
    refused({"-o", "a.xyz", "--levels", "2"}, 2, "expected a name that ends in .ply");
    refused({"-o", "a", "--levels", "2"}, 2, "expected a name that ends in .ply");
    refused({"-o", "a.ply", "--format", "fbx", "--levels", "2"}, 2, "expected a name");
    refused({"-o", "a.ply", "--levels", "-1"}, 2, "--levels");
    refused({"-o", "a.ply", "--detail", "0"}, 2, "--detail");
    refused({"-o", "a.ply", "--levels", "60"}, 2, "expected at most 1000000000 cells");
    refused({"-o", "a.pov", "--detail", "0.1"}, 2, "say --levels instead");
    refused({"-o", "a.stl", "--levels", "12"}, 2, "an STL file holds at most 4294967295 triangles");
    refused({"-o", "tetra.pxm", "--format", "ply", "--levels", "2"}, 2, "tetra.pxm");
    refused({"-o", "none/a.ply", "--levels", "2"}, 4, "none/a.ply");
    refused({"-o", "a.ply", "--levels", "2", "--shape", "none.obj"}, 4, "none.obj");
    refused({"-o", "a.ply", "--levels", "2", "--volume", "egg"}, 2, "egg");
}

}  // namespace
}  // namespace pxm::test
