// Laws of the surfaces that stand for cells: closed, outward, and as large as what they stand for.
#include "host/export/mesh.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <glm/geometric.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "host/compiled/bounding_volume.hpp"
#include "host/error.hpp"
#include "tests/support/folder.hpp"

namespace pxm::test {
namespace {

using namespace host;
using testing::HasSubstr;

TEST(ExportMesh, of_a_box_is_the_box) {
    const Mesh mesh = mesh_of(box_volume({-1, 0, 2}, {1, 3, 4}));
    EXPECT_EQ(mesh.vertices.size(), 8U);
    EXPECT_EQ(mesh.faces.size(), 6U);
    EXPECT_TRUE(is_closed(mesh));
    EXPECT_DOUBLE_EQ(volume_of(mesh), 2 * 3 * 2);
}

TEST(ExportMesh, of_an_oriented_box_looks_outward_whatever_hand_its_axes_are_of) {
    for (const double side : {1.0, -1.0}) {
        const Mesh mesh = mesh_of(
            oriented_volume({{1, 1, 1}, {{{0.6, 0.8, 0}, {-1.6, 1.2, 0}, {0, 0, side * 3}}}}));
        EXPECT_TRUE(is_closed(mesh));
        EXPECT_NEAR(volume_of(mesh), 8 * 1 * 2 * 3, 1e-12);
    }
}

TEST(ExportMesh, of_a_ball_has_its_corners_on_it) {
    const glm::dvec3 center{1, 2, 3};
    const Mesh mesh = mesh_of(sphere_volume(center, 2));
    EXPECT_EQ(mesh.vertices.size(), 42U);
    EXPECT_EQ(mesh.faces.size(), 80U);
    EXPECT_TRUE(is_closed(mesh));
    for (const glm::dvec3& v : mesh.vertices) EXPECT_NEAR(glm::distance(v, center), 2, 1e-12);
    const double ball = 4.0 / 3 * std::numbers::pi * 8;
    EXPECT_LT(volume_of(mesh), ball);
    EXPECT_GT(volume_of(mesh), 0.85 * ball);
}

TEST(ExportMesh, of_cones_and_cylinders_are_prisms) {
    const double disc = 16 * std::sin(std::numbers::pi / 16);  // a polygon of 32 corners
    EXPECT_TRUE(is_closed(mesh_of(cone_volume())));
    EXPECT_NEAR(volume_of(mesh_of(cone_volume())), disc / 3, 1e-12);
    EXPECT_TRUE(is_closed(mesh_of(cylinder_volume())));
    EXPECT_NEAR(volume_of(mesh_of(cylinder_volume())), disc * 2, 1e-12);
}

/// |x| + |y| + |z| <= 1, and a cube whose corners are cut.
TEST(ExportMesh, of_a_hull_is_the_polytope) {
    Polytope sides;
    for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0})
            for (const double z : {-1.0, 1.0})
                sides.push_back({glm::normalize(glm::dvec3{x, y, z}), 1 / std::sqrt(3.0)});
    const Mesh octahedron = mesh_of(hull_volume(sides, {0, 0, 0}));
    EXPECT_TRUE(is_closed(octahedron));
    EXPECT_NEAR(volume_of(octahedron), 4.0 / 3, 1e-12);
    for (HalfSpace& side : sides) side.offset = 2 / std::sqrt(3.0);
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {-1.0, 1.0}) {
            glm::dvec3 normal{0.0};
            normal[axis] = sign;
            sides.push_back({normal, 1});
        }
    const Mesh cut = mesh_of(hull_volume(sides, {0, 0, 0}));
    EXPECT_TRUE(is_closed(cut));
    EXPECT_NEAR(volume_of(cut), 8 - 8.0 / 6, 1e-12);  // a cuboctahedron
}

TEST(ExportMesh, stays_outward_when_it_is_mirrored) {
    const Mesh mesh = image_of(mesh_of(box_volume({0, 0, 0}, {1, 1, 1})), scaling({-2, 1, 1}));
    EXPECT_TRUE(is_closed(mesh));
    EXPECT_DOUBLE_EQ(volume_of(mesh), 2);
}

TEST(ExportMesh, that_is_open_is_told_from_one_that_is_closed) {
    Mesh mesh = mesh_of(box_volume({0, 0, 0}, {1, 1, 1}));
    mesh.faces.pop_back();
    EXPECT_FALSE(is_closed(mesh));
}

const char* const tetrahedron =
    "# inside out\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
    "vn 0 0 1\nf 1/1 2/1 3/1\nf 1 4 2\nf -4 -2 -1\nf 2 4 3\n";

TEST(ExportMesh, is_read_from_obj_and_turned_outward) {
    Folder folder;
    folder.write("a.obj", tetrahedron);
    const Mesh mesh = read_mesh(folder.path("a.obj"));
    EXPECT_EQ(mesh.vertices.size(), 4U);
    EXPECT_TRUE(is_closed(mesh));
    EXPECT_NEAR(volume_of(mesh), 1.0 / 6, 1e-15);
}

TEST(ExportMesh, is_read_from_ply_as_text_and_binary) {
    Folder folder;
    const std::string head =
        "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
        "property uchar red\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n";
    folder.write("text.ply", "ply\nformat ascii 1.0\ncomment c\n" + head +
                                 "0 0 0 9\n1 0 0 9\n0 1 0 9\n0 0 1 9\n"
                                 "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
    std::string body;
    const auto put = [&](auto value) {
        body.append(reinterpret_cast<const char*>(&value), sizeof value);
    };
    for (const std::array<float, 3>& v :
         {std::array<float, 3>{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
        put(v);
        put(std::uint8_t{9});
    }
    for (const std::array<std::int32_t, 3>& f :
         {std::array<std::int32_t, 3>{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}) {
        put(std::uint8_t{3});
        put(f);
    }
    folder.write("binary.ply", "ply\nformat binary_little_endian 1.0\n" + head + body);
    for (const char* name : {"text.ply", "binary.ply"}) {
        const Mesh mesh = read_mesh(folder.path(name));
        EXPECT_TRUE(is_closed(mesh)) << name;
        EXPECT_NEAR(volume_of(mesh), 1.0 / 6, 1e-15) << name;
    }
    const std::string whole = folder.read("binary.ply");
    for (std::size_t bytes = 0; bytes < whole.size(); bytes += 7) {
        folder.write("cut.ply", whole.substr(0, bytes));
        EXPECT_THROW((void)read_mesh(folder.path("cut.ply")), Error) << bytes;
    }
}

std::string refusal_of(const std::string& text) {
    Folder folder;
    folder.write("a.obj", text);
    try {
        (void)read_mesh(folder.path("a.obj"));
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::scene);
        return error.what();
    }
    return "";
}

TEST(ExportMesh, that_is_wrong_is_refused_with_its_line) {
    EXPECT_THAT(refusal_of(""), HasSubstr("expected faces, found none"));
    EXPECT_THAT(refusal_of("v 0 0\n"), HasSubstr("a.obj:1:1: error: expected three numbers"));
    EXPECT_THAT(refusal_of("v 0 0 0\nv 0 x 0\n"),
                HasSubstr("a.obj:2:1: error: expected a number, found 'x'"));
    EXPECT_THAT(refusal_of("v 0 0 0\nf 1 2 3\n"), HasSubstr("names a vertex that is not there"));
    EXPECT_THAT(refusal_of("v 0 0 0\nf 1 1\n"), HasSubstr("at least 3 corners"));
    EXPECT_THAT(refusal_of("ply\nformat ascii 1.0\nend_header\n"), HasSubstr("expected faces"));
    EXPECT_THAT(refusal_of("ply\nformat binary_big_endian 1.0\n"), HasSubstr("expected PLY as"));
}

}  // namespace
}  // namespace pxm::test
