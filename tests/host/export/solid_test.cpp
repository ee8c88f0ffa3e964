// Distances to the solids that stand for cells, held against points of their surfaces.
#include "host/export/solid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <random>
#include <vector>

#include "host/compiled/bounding_volume.hpp"

namespace pxm::host {
namespace {

constexpr double reach = 100;

Affine turned() {
    return then(then(rotation(Axis::x, 33), rotation(Axis::z, -71)), translation({0.3, -1, 2}));
}
Affine sheared() { return then(then(scaling({1, 0.3, 2}), turned()), scaling({0.7, 1.5, 1})); }

std::vector<CompiledVolume> volumes() {
    const OrientedBox oriented{{1, 2, 3}, {{{0.6, 0.8, 0}, {-0.4, 0.3, 0}, {0, 0, 0.2}}}};
    return {sphere_volume({1, -1, 0.5}, 0.8), box_volume({-1, 0, 1}, {0.5, 0.3, 3}),
            oriented_volume(oriented), cone_volume(), cylinder_volume()};
}

Solid solid_of(const CompiledVolume& volume, const Affine& place) {
    return {volume, mesh_of(volume), place};
}

double dot_of_faces(const Mesh& mesh, const glm::dvec3& x) {
    double farthest = -std::numeric_limits<double>::infinity();
    for (const auto& [a, b, c] : triangles_of(mesh)) {
        const glm::dvec3 normal = glm::normalize(
            glm::cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]));
        farthest = std::max(farthest, glm::dot(normal, x - mesh.vertices[a]));
    }
    return farthest;
}

/// Of a triangle, by points of it.
double distance_to_triangles(const Mesh& mesh, const glm::dvec3& x) {
    constexpr int steps = 30;
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& [a, b, c] : triangles_of(mesh))
        for (int i = 0; i <= steps; ++i)
            for (int j = 0; i + j <= steps; ++j) {
                const double u = static_cast<double>(i) / steps, v = static_cast<double>(j) / steps;
                nearest = std::min(
                    nearest, glm::distance(x, mesh.vertices[a] * (1 - u - v) +
                                                  mesh.vertices[b] * u + mesh.vertices[c] * v));
            }
    return nearest;
}

glm::dvec3 random_point(std::mt19937& random) {
    std::uniform_real_distribution<double> unit(-4, 4);
    const double x = unit(random), y = unit(random), z = unit(random);
    return {x, y, z};
}

TEST(Solid, is_as_far_away_as_the_nearest_point_of_its_surface) {
    std::mt19937 random(20);
    for (const CompiledVolume& volume : volumes()) {
        if (volume.kind == kernels::Volume::sphere) continue;
        for (const Affine& place : {Affine{}, turned(), sheared()}) {
            const Mesh mesh = image_of(mesh_of(volume), place);
            const Solid solid = solid_of(volume, place);
            const Box3 box = solid.extent({});
            for (int i = 0; i < 16; ++i) {  // about a quarter of them inside
                const glm::dvec3 x = (box.low + box.high) / 2.0 +
                                     random_point(random) / 4.0 * (box.high - box.low) * 0.7;
                const double side = dot_of_faces(mesh, x);
                const double found = solid.distance(x, reach);
                EXPECT_EQ(found < 0, side < 0);
                const double expected = side < 0 ? side : distance_to_triangles(mesh, x);
                EXPECT_NEAR(found, expected, side < 0 ? 1e-12 : 0.1);
            }
        }
    }
}

TEST(Solid, of_a_ball_is_exact_and_of_an_ellipsoid_to_first_order) {
    const CompiledVolume ball = sphere_volume({1, -1, 0.5}, 0.8);
    const Solid moved = solid_of(ball, turned());
    const glm::dvec3 center = turned().point({1, -1, 0.5});
    EXPECT_NEAR(moved.distance(center + glm::dvec3{0, 3, 0}, reach), 2.2, 1e-12);
    EXPECT_NEAR(moved.distance(center, reach), -0.8, 1e-12);
    const Solid squashed = solid_of(ball, sheared());
    std::mt19937 random(21);
    for (int i = 0; i < 100; ++i) {
        const glm::dvec3 unit = glm::normalize(random_point(random));
        const glm::dvec3 surface = sheared().point(glm::dvec3{1, -1, 0.5} + 0.8 * unit);
        const glm::dvec3 normal =
            glm::normalize(unit * glm::inverse(sheared().linear));  // by the inverse transpose
        EXPECT_NEAR(squashed.distance(surface, reach), 0, 1e-12);
        for (const double step : {-0.002, 0.002})
            EXPECT_NEAR(squashed.distance(surface + step * normal, reach), step, 1e-4);
    }
}

/// What divides space by it must not lose the surface.
TEST(Solid, tells_no_more_distance_than_there_is) {
    std::mt19937 random(22);
    for (const CompiledVolume& volume : volumes())
        for (const Affine& place : {Affine{}, turned(), sheared()}) {
            const Solid solid = solid_of(volume, place);
            const Box3 box = solid.extent({});
            for (int i = 0; i < 200; ++i) {
                const glm::dvec3 x = random_point(random);
                const double least = solid.at_least(x, reach);
                EXPECT_EQ(least < 0, solid.distance(x, reach) < 0);
                const glm::dvec3 y = x + 0.3 * random_point(random);
                if (std::abs(least) > glm::distance(x, y)) {
                    EXPECT_EQ(solid.distance(y, reach) < 0, least < 0);
                }
                if (least < 0) {
                    EXPECT_TRUE(glm::all(glm::greaterThanEqual(x, box.low - 1e-9)) &&
                                glm::all(glm::lessThanEqual(x, box.high + 1e-9)));
                }
            }
        }
}

}  // namespace
}  // namespace pxm::host
