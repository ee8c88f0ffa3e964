// Laws of host/export/mesh and obj_reader: shapes are closed, turned outward, and what they stand
// for.
#include "host/export/mesh.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "host/compiled/bounding_volume.hpp"
#include "host/error.hpp"
#include "host/export/obj_reader.hpp"

namespace pxm::test {
namespace {

using namespace host;
using testing::HasSubstr;

Polytope octahedron() {
    Polytope sides;
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 u{i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1};
        sides.push_back({u / std::sqrt(3.0), 1 / std::sqrt(3.0)});
    }
    return sides;
}

struct Known {
    CompiledVolume volume;
    double least;  // of the cubed lengths inside
    double most;
};

std::vector<Known> known_volumes() {
    constexpr double pi = std::numbers::pi;
    return {{sphere_volume({1, 2, 3}, 2), 0.95 * 32 * pi / 3, 32 * pi / 3},
            {box_volume({-1, 0, 2}, {1, 3, 7}), 29.999999, 30.000001},
            {oriented_volume({{1, 2, 3}, {{{3, 0, 0}, {0, 0, 2}, {0, 6, 0}}}}), 287.9999, 288.0001},
            {hull_volume(octahedron(), {0, 0, 0}), 4.0 / 3 - 1e-9, 4.0 / 3 + 1e-9},
            {cone_volume(), 0.98 * pi / 3, pi / 3},
            {cylinder_volume(), 0.98 * 2 * pi, 2 * pi}};
}

TEST(Mesh, of_every_volume_is_closed_and_turned_outward) {
    for (const Known& known : known_volumes()) {
        const Mesh mesh = mesh_of(known.volume);
        EXPECT_TRUE(is_closed(mesh)) << static_cast<int>(known.volume.kind);
        EXPECT_GE(volume_inside(mesh), known.least) << static_cast<int>(known.volume.kind);
        EXPECT_LE(volume_inside(mesh), known.most) << static_cast<int>(known.volume.kind);
    }
}

TEST(Mesh, a_hole_or_a_turned_triangle_is_not_closed) {
    Mesh mesh = mesh_of(box_volume({0, 0, 0}, {1, 1, 1}));
    std::swap(mesh.triangles[3][0], mesh.triangles[3][1]);
    EXPECT_FALSE(is_closed(mesh));
    mesh = mesh_of(box_volume({0, 0, 0}, {1, 1, 1}));
    mesh.triangles.pop_back();
    EXPECT_FALSE(is_closed(mesh));
    EXPECT_FALSE(is_closed(Mesh{}));
}

TEST(ObjReader, takes_faces_of_any_number_of_corners_however_they_are_counted) {
    const Mesh mesh = mesh_of_obj("a.obj",
                                  "# a pyramid\r\no p\nv 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\n"
                                  "vn 0 1 0\nv 0.5 1 0.5\ns off\nf 1 2 3 4\nf 1/1/1 5/2 2\n"
                                  "f 2//1 -1 3\nf 3 5 4\nf 4 5 1\n");
    EXPECT_EQ(mesh.vertices.size(), 5U);
    EXPECT_EQ(mesh.triangles.size(), 6U);
    EXPECT_TRUE(is_closed(mesh));
    EXPECT_NEAR(volume_inside(mesh), 1.0 / 3, 1e-12);
}

TEST(ObjReader, what_is_wrong_is_told_with_its_place) {
    struct Wrong {
        const char* text;
        const char* told;
    };
    const Wrong wrongs[] = {
        {"", "a.obj:1:1: error: expected a face (f), found none"},
        {"v 1 2\n", "a.obj:1:6: error: expected a coordinate, found \"\""},
        {"v 1 2 nan\n", "a.obj:1:7: error: expected a coordinate, found \"nan\""},
        {"v 1 2 3x\n", "a.obj:1:7: error: expected a coordinate, found \"3x\""},
        {"v 0 0 0\nf 1 1\n", "a.obj:2:6: error: expected three corners or more of a face"},
        {"v 0 0 0\n  f 1 2 1\n", "a.obj:2:7: error: expected a vertex from 1 to 1, found \"2\""},
        {"v 0 0 0\nf 0 1 1\n", "a.obj:2:3: error: expected a vertex from 1 to 1, found \"0\""},
        {"v 0 0 0\nf -2 1 1\n", "a.obj:2:3: error: expected a vertex from 1 to 1, found \"-2\""},
        {"f 1 1 99999999999999999999\n", "expected a vertex from 1 to 0"}};
    for (const Wrong& wrong : wrongs) {
        try {
            (void)mesh_of_obj("a.obj", wrong.text);
            ADD_FAILURE() << wrong.text;
        } catch (const Error& error) {
            EXPECT_THAT(error.what(), HasSubstr(wrong.told));
            EXPECT_EQ(error.kind(), ErrorKind::scene);
            EXPECT_EQ(error.mistakes().size(), 1U);
        }
    }
}

}  // namespace
}  // namespace pxm::test
