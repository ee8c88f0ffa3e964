// Maps from four points (Sec. 9.3): exact where corners are, and a clear refusal of flat ones.
#include <gtest/gtest.h>

#include "tests/host/scene/scene_text.hpp"

namespace pxm::test {
namespace {

TEST(Tetrahedron, a_flat_one_is_refused_at_its_command) {
    EXPECT_EQ(
        check_messages("ifs fern {\n"
                       "    newmap stem\n"
                       "        scale: 0.5\n"
                       "        tetrahedron: (0,0,0)(1,0,0)(0,1,0)(1,1,0) -> "
                       "(0,0,0)(1,0,0)(0,1,0)(0,0,1)\n"
                       "}\n"),
        "s.pxm:4:9: error: ifs \"fern\": map \"stem\": the four points of the tetrahedron lie "
        "in a plane\n"
        "    tetrahedron: (0,0,0)(1,0,0)(0,1,0)(1,1,0) -> (0,0,0)(1,0,0)(0,1,0)(0,0,1)\n"
        "    ^");
}

TEST(Tetrahedron, a_flat_image_is_a_singular_map_and_taken) {
    EXPECT_EQ(check_messages("ifs a { newmap tetrahedron: (0,0,0)(1,0,0)(0,1,0)(0,0,1) -> "
                             "(0,0,0)(0.5,0,0)(0,0.5,0)(0,0,0) }"),
              "");
}

TEST(Tetrahedron, powers_of_two_are_mapped_without_rounding) {
    const auto scene = parsed(
        "ifs a { newmap tetrahedron: (1,1,1)(3,1,1)(1,5,1)(1,1,-7) -> "
        "(0.25,0,0)(0.75,0.5,0)(0.25,0.5,-2)(4,0,0.125) }");
    const host::Affine map = host::compose(scene.ifs.at(0).maps.at(0).commands);
    EXPECT_EQ(map.point({1, 1, 1}), glm::dvec3(0.25, 0, 0));
    EXPECT_EQ(map.point({3, 1, 1}), glm::dvec3(0.75, 0.5, 0));
    EXPECT_EQ(map.point({1, 5, 1}), glm::dvec3(0.25, 0.5, -2));
    EXPECT_EQ(map.point({1, 1, -7}), glm::dvec3(4, 0, 0.125));
}

}  // namespace
}  // namespace pxm::test
