// Laws of point inclusion (Alg. 7.2): the picture of a flat attractor is that of its points.
#include "dsp_kernels/texture_inclusion.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <random>

#include "tests/support/floor_node.hpp"

namespace pxm::test {
namespace {

using namespace host;

const std::string gasket =
    "ifs a { newmap scale: 0.5 newmap scale: 0.5 translate: 0.5,0,0 "
    "newmap scale: 0.5 translate: 0,0.5,0 }";
// Not similar, one map mirrored, and graphs that are not symmetric (Erratum 4).
const std::string fern =
    "ifs a { newmap scale: 0.8,0.85,0.5 rotate: z,4 translate: 0,0.3,0 newmap scale: 0.3,0.25,0.5 "
    "rotate: z,50 translate: 0.1,0.2,0 newmap scale: -0.3,0.3,0.5 rotate: z,-40 translate: "
    "-0.1,0.2,0 }";
const std::string graph =
    "ifs a { newmap l scale: 0.5 newmap r scale: 0.5 rotate: z,90 translate: 0.5,0,0 "
    "newmap t scale: 0.5 translate: 0,0.5,0 follow: l -> r follow: r -> t, l follow: t -> t, l }";
const std::string line = "ifs a { newmap scale: 1/3 newmap scale: 1/3 translate: 2/3,0,0 }";

std::string floor_with(const std::string& ifs) {
    return ifs +
           "texture t { ifs: a color: 1,1,1 color2: 0,0,0 } plane { normal: 0,1,0 texture: t }";
}

/// Points no farther than `size` from each point of the attractor, in repeats, by all words.
void enumerate(const CompiledTexture& texture, int set, const glm::dmat2& linear,
               const glm::dvec2& offset, double size, std::vector<glm::dvec2>& points) {
    const CompiledPointSet& here = texture.sets[static_cast<std::size_t>(set)];
    const double stretch = glm::length(linear[0]) + glm::length(linear[1]);
    if (stretch * here.radius < size) {
        points.push_back(linear * here.center + offset);
        return;
    }
    for (const int m : here.maps) {
        const CompiledPointMap& map = texture.maps[static_cast<std::size_t>(m)];
        enumerate(texture, map.set, linear * glm::dmat2{map.linear[0], map.linear[1]},
                  linear * map.offset + offset, size, points);
    }
}

std::vector<glm::dvec2> points_of(const CompiledScene& scene, double size) {
    const CompiledTexture& texture = scene.textures.at(0);
    std::vector<glm::dvec2> points;
    enumerate(texture, texture.start, glm::dmat2{texture.step.x, 0.0, 0.0, texture.step.y},
              texture.corner, size, points);
    return points;
}

/// 1 - the distance to the nearest point in diameters of the spot, no less than 0.
double coverage_by_points(const std::vector<glm::dvec2>& points, const glm::dvec2& at,
                          const glm::dvec2& minor, const glm::dvec2& major) {
    const glm::dmat2 to_spot = glm::inverse(glm::dmat2{minor, major});
    double nearest = 1;
    for (const glm::dvec2& point : points) {
        for (const double right : {-1, 0, 1}) {
            for (const double up : {-1, 0, 1}) {
                const glm::dvec2 tile{std::floor(at.x) + right, std::floor(at.y) + up};
                nearest = std::min(nearest, glm::length(to_spot * (point + tile - at)));
            }
        }
    }
    return 1 - nearest;
}

class Included : public testing::TestWithParam<const std::string*> {};

TEST_P(Included, coverage_is_one_less_the_distance_to_the_nearest_point) {
    const CompiledScene scene = compile_text(floor_with(*GetParam()));
    FloorNode<double> node(scene);
    FloorNode<float> single(scene);
    FloorNode<dsp32::Float> chip(scene);
    const double size = 2e-3;
    const std::vector<glm::dvec2> points = points_of(scene, size);
    std::mt19937 random(6);
    std::uniform_real_distribution<double> place(-1, 2);
    double covered = 0;
    for (int trial = 0; trial < 60; ++trial) {
        glm::dvec2 at{place(random), place(random)};
        if (trial % 2 == 0) at = points[random() % points.size()] + at / 30.0;
        const double diameter = std::exp2(-4 - place(random));
        const double angle = place(random);
        const glm::dvec2 minor = glm::dvec2{std::cos(angle), std::sin(angle)} * diameter;
        const glm::dvec2 major = glm::dvec2{-minor.y, minor.x} * 1.7;
        const double expected = coverage_by_points(points, at, minor, major);
        const double error = kernels::inclusion_fineness + size / diameter;
        EXPECT_NEAR(node.color(at, minor, major).x, expected, error);
        EXPECT_NEAR(single.color(at, minor, major).x, expected, error + 1e-3);
        EXPECT_NEAR(chip.color(at, minor, major).x, expected, error + 1e-3);
        covered += expected;
    }
    EXPECT_GT(covered, 10);
}

std::string system_name(const testing::TestParamInfo<const std::string*>& system) {
    return system.param == &gasket ? "gasket" : system.param == &fern ? "fern" : "graph";
}

INSTANTIATE_TEST_SUITE_P(Systems, Included, testing::Values(&gasket, &fern, &graph), system_name);

TEST(Inclusion, the_gasket_s_picture_has_the_area_of_the_thickened_gasket) {
    const CompiledScene scene = compile_text(floor_with(gasket));
    FloorNode<float> node(scene);
    const auto area = [&](double diameter) {
        double sum = 0;
        constexpr int steps = 200;
        for (int i = 0; i < steps; ++i) {
            for (int j = 0; j < steps; ++j) {
                sum += node.color({(i + 0.5) / steps, (j + 0.5) / steps}, diameter).x;
            }
        }
        return sum / (steps * steps);
    };
    // Dimension log 3 / log 2: half the pixel, 3/4 of the area.
    const double coarse = area(1.0 / 32);
    const double fine = area(1.0 / 64);
    EXPECT_NEAR(fine / coarse, 0.75, 0.02);
    // At level 6 the gasket is 3^6 triangles with legs of 1/64.
    const double triangles = 0.5 * std::pow(0.75, 6);
    EXPECT_GT(coarse, triangles);
    EXPECT_LT(fine, 3 * triangles);
}

TEST(Inclusion, every_point_of_the_attractor_is_on_the_picture) {
    for (const std::string* system : {&gasket, &fern, &graph}) {
        const CompiledScene scene = compile_text(floor_with(*system));
        FloorNode<float> node(scene);
        const std::vector<glm::dvec2> points = points_of(scene, 1e-3);
        for (std::size_t i = 0; i < points.size(); i += points.size() / 200 + 1) {
            EXPECT_GE(node.color(points[i], 0.02).x, 1 - kernels::inclusion_fineness - 0.05);
        }
    }
}

TEST(Inclusion, the_box_of_the_attractor_fills_a_repeat) {
    for (const std::string* system : {&gasket, &fern, &graph}) {
        const CompiledScene scene = compile_text(floor_with(*system));
        glm::dvec2 low{1e9};
        glm::dvec2 high{-1e9};
        for (const glm::dvec2& point : points_of(scene, 5e-3)) {
            low = glm::min(low, point);
            high = glm::max(high, point);
        }
        EXPECT_LT(glm::length(low), 0.01);
        EXPECT_LT(glm::length(high - 1.0), 0.01);
    }
}

TEST(Inclusion, a_line_lies_in_the_middle_of_its_repeat) {
    const CompiledScene scene =
        compile_text(line +
                     "texture t { ifs: a color: 1,1,1 color2: 0,0,0 size: 1,1 } "
                     "plane { normal: 0,1,0 texture: t }");
    FloorNode<float> node(scene);
    EXPECT_GT(node.color({0.01, 0.5}, 0.05).x, 0.8);
    EXPECT_EQ(node.color({0.5, 0.5}, 0.05).x, 0);
    EXPECT_EQ(node.color({0.01, 0.2}, 0.05).x, 0);
}

TEST(Inclusion, far_away_all_of_a_repeat_is_covered) {
    FloorNode<float> node(compile_text(floor_with(gasket)));
    EXPECT_GT(node.color({0.9, 0.9}, 20).x, 0.9);
    EXPECT_EQ(node.color({0.9, 0.9}, 1e7).x, 1);
}

TEST(Inclusion, an_ifs_with_depth_is_no_texture) {
    const std::string message = "texture \"t\": ifs \"a\" is not flat: a map takes z into x or y";
    try {
        (void)compile_text(floor_with("ifs a { newmap scale: 0.5 rotate: x,20 }"));
        FAIL();
    } catch (const std::exception& error) {
        EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
    }
    EXPECT_NO_THROW((void)compile_text(floor_with("ifs a { newmap scale: 0.5 rotate: z,20 }")));
    EXPECT_NO_THROW((void)compile_text(floor_with("ifs a { newmap scale: 0.5 rotate: x,180 }")));
}

}  // namespace
}  // namespace pxm::test
