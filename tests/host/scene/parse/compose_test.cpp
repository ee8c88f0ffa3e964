// Laws of composition: commands post-multiply; a tetrahedron takes corners to corners.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <random>
#include <stdexcept>

#include "tests/host/scene/scene_text.hpp"

namespace pxm::host {
namespace {

Affine map_of(const std::string& commands) {
    return compose(test::parsed("ifs a { newmap " + commands + " }").ifs.at(0).maps.at(0).commands);
}

TEST(Compose, no_commands_are_the_identity) { EXPECT_EQ(map_of(""), Affine{}); }

TEST(Compose, commands_apply_in_the_order_written) {
    // (1,0,0) -> scaled (2,0,0) -> turned +x toward +y (0,2,0) -> moved (5,2,0)
    EXPECT_EQ(map_of("scale: 2,1,1 rotate: z,90 translate: 5,0,0").point({1, 0, 0}),
              glm::dvec3(5, 2, 0));
    EXPECT_EQ(map_of("translate: 5,0,0 rotate: z,90 scale: 2,1,1").point({1, 0, 0}),
              glm::dvec3(0, 6, 0));
}

TEST(Compose, a_matrix_is_written_in_rows_and_row_four_moves) {
    const Affine map = map_of("matrix: 1,2,3, 4,5,6, 7,8,9, 10,11,12");
    EXPECT_EQ(map.point({1, 0, 0}), glm::dvec3(11, 13, 15));
    EXPECT_EQ(map.point({0, 0, 1}), glm::dvec3(17, 19, 21));
    EXPECT_EQ(map_of("translate: 1,0,0 matrix: 1,2,3, 4,5,6, 7,8,9, 10,11,12").point({0, 0, 0}),
              glm::dvec3(11, 13, 15));
}

TEST(Compose, a_tetrahedron_of_exact_corners_is_an_exact_map) {
    const Affine map = map_of(
        "tetrahedron: (1,1,1)(2,1,1)(1,3,1)(1,1,4) -> (0,0,0)(0.5,0,0)(0,0.5,0)(0,0.25,0.5)");
    EXPECT_EQ(map.point({1, 1, 1}), glm::dvec3(0, 0, 0));
    EXPECT_EQ(map.point({2, 1, 1}), glm::dvec3(0.5, 0, 0));
    EXPECT_EQ(map.point({1, 3, 1}), glm::dvec3(0, 0.5, 0));
    EXPECT_EQ(map.linear[0], glm::dvec3(0.5, 0, 0));
}

TEST(Compose, a_tetrahedron_takes_each_corner_to_its_image) {
    for (unsigned seed = 0; seed < 500; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> number(-3, 3);
        TetrahedronCommand command;
        for (int i = 0; i < 4; ++i) {
            const auto k = static_cast<std::size_t>(i);
            command.from[k] = {number(random), number(random), number(random)};
            command.to[k] = {number(random), number(random), number(random)};
        }
        const auto& p = command.from;
        const double volume = glm::dot(p[1] - p[0], glm::cross(p[2] - p[0], p[3] - p[0]));
        if (std::abs(volume) < 0.1) continue;
        const Affine map = compose({{command, {}}});
        for (std::size_t i = 0; i < 4; ++i)
            EXPECT_LT(glm::distance(map.point(p[i]), command.to[i]), 1e-11);
    }
}

TEST(Compose, a_flat_tetrahedron_has_no_map) {
    const std::string to = " -> (0,0,0)(1,0,0)(0,1,0)(0,0,1)";
    EXPECT_THROW(map_of("tetrahedron: (0,0,0)(1,0,0)(0,1,0)(1/3,1/3,0)" + to), std::domain_error);
    EXPECT_THROW(map_of("tetrahedron: (1,2,3)(1,2,3)(1,2,3)(1,2,3)" + to), std::domain_error);
    EXPECT_THROW(map_of("tetrahedron: (.1,.2,.3)(.2,.4,.6)(.3,.6,.9)(.7,.1,.3)" + to),
                 std::domain_error);
    EXPECT_NO_THROW(map_of("tetrahedron: (0,0,0)(1e-9,0,0)(0,1e-9,0)(0,0,1e-9)" + to));
}

}  // namespace
}  // namespace pxm::host
