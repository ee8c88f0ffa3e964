// Laws of dsp_kernels/plane.hpp and footprint.hpp: where rays meet planes, and what a pixel covers
// of one.
#include "dsp_kernels/plane.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <random>

#include "tests/support/floor_node.hpp"

namespace pxm::test {
namespace {

using namespace host;

template <class Real>
class Plane : public testing::Test {};
using Reals = testing::Types<dsp32::Float, float, double>;
TYPED_TEST_SUITE(Plane, Reals);

template <class Real>
constexpr double digits = real_words<Real> == 1 ? 2e-5 : 1e-12;

std::string eye_at_origin(const std::string& text) {
    return text + "camera { eye: 0,0,0 look: 0,0,1 }";
}

glm::dvec3 random_direction(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return glm::normalize(glm::dvec3{normal(random), normal(random), normal(random)});
}

/// The nearest plane by the formula, in double: its number and t, or -1.
std::pair<int, double> nearest(const CompiledScene& scene, const glm::dvec3& origin,
                               const glm::dvec3& direction) {
    std::pair<int, double> found{-1, 1e30};
    for (std::size_t i = 0; i < scene.planes.size(); ++i) {
        const CompiledPlane& plane = scene.planes[i];
        const double t =
            (plane.offset - glm::dot(origin, plane.normal)) / glm::dot(direction, plane.normal);
        if (t > 0 && t < found.second) found = {static_cast<int>(i), t};
    }
    return found;
}

TYPED_TEST(Plane, a_ray_meets_the_one_that_the_formula_says) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> part(-2, 2);
    for (int scenes = 0; scenes < 10; ++scenes) {
        std::string text;
        for (int i = 0; i < 4; ++i) {
            const glm::dvec3 n = random_direction(random) * 3.0;
            text += fmt::format("plane {{ point: {},{},{} normal: {},{},{} }}\n", part(random),
                                part(random), part(random), n.x, n.y, n.z);
        }
        const CompiledScene scene = compile_text(eye_at_origin(text));
        FloorNode<TypeParam> node(scene);
        for (int rays = 0; rays < 100; ++rays) {
            const glm::dvec3 origin{part(random), part(random), part(random)};
            const glm::dvec3 direction = random_direction(random);
            const auto [plane, t] = nearest(scene, origin, direction);
            const kernels::Ray<TypeParam> ray{node.vector(origin), node.vector(direction)};
            kernels::PlaneHit<TypeParam> hit;
            const bool met =
                nearest_plane(node, ray, TypeParam(0), from_double<TypeParam>(100.0), hit);
            if (t > 99 && t < 101) continue;
            ASSERT_EQ(met, t < 100);
            if (!met) continue;
            const glm::dvec3 normal = scene.planes[static_cast<std::size_t>(plane)].normal;
            const double facing = std::abs(glm::dot(direction, normal));
            if (facing < 0.01) continue;
            // Another one as near, but for rounding, is as right.
            EXPECT_NEAR(to_double(hit.t), t, digits<TypeParam> * (1 + t) / facing);
        }
    }
}

TYPED_TEST(Plane, only_what_lies_between_the_two_ends_counts) {
    const CompiledScene scene =
        compile_text(eye_at_origin("plane { point: 0,0,2 normal: 0,0,1 }"
                                   "plane { point: 0,0,3 normal: 0,0,1 }"));
    FloorNode<TypeParam> node(scene);
    const kernels::Ray<TypeParam> ray{node.vector({0, 0, 0}), node.vector({0, 0, 1})};
    const auto seen = [&](double from, double to) {
        kernels::PlaneHit<TypeParam> hit;
        const bool met =
            nearest_plane(node, ray, from_double<TypeParam>(from), from_double<TypeParam>(to), hit);
        return met ? to_double(hit.t) : 0.0;
    };
    EXPECT_EQ(seen(0, 10), 2);
    EXPECT_EQ(seen(2, 10), 3);
    EXPECT_EQ(seen(0, 2), 0);
    EXPECT_EQ(seen(3, 10), 0);
    const kernels::Ray<TypeParam> along{node.vector({0, 0, 0}), node.vector({1, 0, 0})};
    kernels::PlaneHit<TypeParam> hit;
    EXPECT_FALSE(nearest_plane(node, along, TypeParam(0), from_double<TypeParam>(1e30), hit));
}

TYPED_TEST(Plane, its_normal_faces_the_ray_from_either_side) {
    const CompiledScene scene =
        compile_text(eye_at_origin("plane { point: 0,0,2 normal: 0,0,5 color: 0.5,0.25,1 } "
                                   "plane { point: 0,0,-2 normal: 0,0,5 }"));
    FloorNode<TypeParam> node(scene);
    for (const double side : {1.0, -1.0}) {
        const kernels::Ray<TypeParam> ray{node.vector({0, 0, 0}), node.vector({0, 0, side})};
        kernels::PlaneHit<TypeParam> hit;
        ASSERT_TRUE(nearest_plane(node, ray, TypeParam(0), from_double<TypeParam>(9.0), hit));
        const auto surface = plane_surface(node, ray, from_double<TypeParam>(0.1), hit);
        EXPECT_EQ(to_double(surface.normal.z), -side);
        EXPECT_EQ(hit.plane, node.plane(side > 0 ? 0 : 1));
        EXPECT_EQ(to_double(surface.color.y), side > 0 ? 0.25 : to_double(TypeParam(0.9)));
    }
}

// A pixel is a disc across the ray; the footprint is its shadow along the ray.
TYPED_TEST(Plane, a_footprint_is_the_disc_of_a_pixel_cast_along_the_ray) {
    std::mt19937 random(8);
    const CompiledScene scene = compile_text(eye_at_origin("plane { normal: 0,1,0 }"));
    FloorNode<TypeParam> node(scene);
    for (int trial = 0; trial < 200; ++trial) {
        const glm::dvec3 d = random_direction(random);
        const glm::dvec3 n = trial == 0 ? d : random_direction(random);
        const double cosine = std::abs(glm::dot(d, n));
        if (cosine < 0.05) continue;
        const double p = 0.3;
        const auto foot =
            kernels::footprint(node, node.vector(d), node.vector(n), from_double<TypeParam>(p));
        const auto axis = [](const kernels::Vec3<TypeParam>& v) {
            return glm::dvec3{to_double(v.x), to_double(v.y), to_double(v.z)};
        };
        const glm::dvec3 minor = axis(foot.minor);
        const glm::dvec3 major = axis(foot.major);
        EXPECT_EQ(foot.spots, std::min(16, static_cast<int>(1 / cosine + 0.5)));
        EXPECT_NEAR(glm::dot(minor, n), 0, 1e-4);
        EXPECT_NEAR(glm::dot(major, n), 0, 1e-4 / cosine);
        const glm::dvec3 side = glm::normalize(
            glm::cross(d, std::abs(d.x) < 0.5 ? glm::dvec3{1, 0, 0} : glm::dvec3{0, 1, 0}));
        for (int step = 0; step < 8; ++step) {
            const double angle = step * 0.8;
            const glm::dvec3 rim =
                p / 2 * (std::cos(angle) * side + std::sin(angle) * glm::cross(d, side));
            const glm::dvec3 cast = rim - d * (glm::dot(rim, n) / glm::dot(d, n));
            const double a = glm::dot(cast, minor) / glm::dot(minor, minor);
            const double b = glm::dot(cast, major) / glm::dot(major, major);
            EXPECT_NEAR(a * a + b * b, 0.25, 0.25 * 4e-3) << trial;
        }
    }
}

TYPED_TEST(Plane, a_coordinate_is_its_repeat_and_the_place_in_it) {
    const CompiledScene scene = compile_text(eye_at_origin("plane { normal: 0,1,0 }"));
    FloorNode<TypeParam> node(scene);
    for (const double x :
         {0.0, 0.25, -0.25, 1.0, -1.0, 7.75, -16383.5, 16384.5, -100'000.5, 500'000.25, -1e-12}) {
        const auto place = kernels::place_of(node, from_double<TypeParam>(x));
        const double fraction = to_double(place.fraction);
        EXPECT_GE(fraction, 0);
        EXPECT_LT(fraction, 1);
        EXPECT_NEAR(std::remainder(fraction - x, 1.0), 0, 1e-6) << x;
        const double whole = std::round(x - fraction);
        const double repeat = static_cast<std::int32_t>(place.repeat);
        EXPECT_EQ(std::fmod(whole - repeat, 16384.0), 0) << x;
        if (std::abs(x) < 16000) {
            EXPECT_EQ(repeat, whole) << x;
        }
    }
}

TEST(PlaneFrame, u_and_v_of_a_floor_are_x_and_z_and_v_goes_up_a_wall) {
    const auto frame = [](const char* normal) {
        const CompiledScene scene = compile_text(eye_at_origin(fmt::format(
            "texture t {{ wood size: 4,2 }} plane {{ point: 1,-8,5 normal: {} texture: t }}",
            normal)));
        return std::pair(scene.planes[0].layers[0].across * 4.0,
                         scene.planes[0].layers[0].along * 2.0);
    };
    using V = glm::dvec3;
    const auto expect = [&](const char* normal, const V& u, const V& v) {
        const auto [across, along] = frame(normal);
        EXPECT_LT(glm::distance(across, u), 1e-12) << normal;
        EXPECT_LT(glm::distance(along, v), 1e-12) << normal;
    };
    expect("0,1,0", {1, 0, 0}, {0, 0, 1});
    expect("0,-3,0", {-1, 0, 0}, {0, 0, 1});
    expect("0,0,-2", {1, 0, 0}, {0, 1, 0});
    expect("0,0,1", {-1, 0, 0}, {0, 1, 0});
    expect("1,0,0", {0, 0, 1}, {0, 1, 0});
}

TEST(PlaneFrame, a_repeat_has_a_corner_at_the_point_of_the_plane) {
    const CompiledScene scene = compile_text(
        "texture t { wood size: 0.4,0.2 } plane { point: 3,-1,7 normal: 0,1,0 texture: t }"
        "camera { eye: -20,5,-30 look: 0,0,0 }");
    const CompiledLayer& layer = scene.planes[0].layers[0];
    const glm::dvec3 corner = (glm::dvec3{3, -1, 7} - glm::dvec3{-20, 5, -30}) / scene.unit;
    const double u = glm::dot(corner - layer.origin, layer.across) + layer.first_u;
    const double v = glm::dot(corner - layer.origin, layer.along) + layer.first_v;
    EXPECT_NEAR(u, 0, 1e-9);
    EXPECT_NEAR(v, 0, 1e-9);
    // The origin is the corner of the repeat below the eye.
    for (const glm::dvec3& axis : {layer.across, layer.along}) {
        EXPECT_GE(glm::dot(-layer.origin, axis), -1e-9);
        EXPECT_LE(glm::dot(-layer.origin, axis), 1 + 1e-9);
    }
}

}  // namespace
}  // namespace pxm::test
