// Laws of which shapes' maps squash so much that rays need care (host/node_program/steepness.hpp).
#include "host/node_program/steepness.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/compile_text.hpp"

namespace pxm::host {
namespace {

bool is_any_steep(const std::string& text) {
    const CompiledScene compiled = test::compile_text(text);
    return std::ranges::count(steep_shapes(compiled), true) > 0;
}

/// Two maps, one of which squashes; the object is some pixels large.
std::string squashed(const std::string& scale, int pixels, const std::string& more = "") {
    return "ifs a { newmap scale: " + scale + " newmap scale: 0.5 translate: 1,0,0 } " +
           "image { size: " + std::to_string(2 * pixels) + "," + std::to_string(2 * pixels) +
           " } camera { eye: 1,0,-9 look: 1,0,0 orthographic: 4 } " + more;
}

TEST(Steepness, similitudes_are_not_steep_however_fine_the_picture) {
    EXPECT_FALSE(is_any_steep(squashed("0.5", 32'768)));
    EXPECT_FALSE(is_any_steep(squashed("0.001", 32'768)));
}

TEST(Steepness, maps_that_squash_little_are_not_steep_however_deep_the_zoom) {
    EXPECT_FALSE(is_any_steep(squashed("0.5,0.2,0.5", 32'768)));
    EXPECT_FALSE(is_any_steep(squashed("0.5,0.01,0.5", 32'768)));
}

TEST(Steepness, the_finer_the_picture_the_less_a_map_may_squash) {
    EXPECT_FALSE(is_any_steep(squashed("0.5,0.0009,0.5", 4)));
    EXPECT_TRUE(is_any_steep(squashed("0.5,0.0009,0.5", 1000)));
    EXPECT_TRUE(is_any_steep(squashed("0.5,0.0001,0.5", 20)));
}

TEST(Steepness, few_levels_squash_less) {
    EXPECT_TRUE(is_any_steep(squashed("0.5,0.0001,0.5", 200, "object a { ifs: a levels: 5 }")));
    EXPECT_FALSE(is_any_steep(squashed("0.5,0.0001,0.5", 200, "object a { ifs: a levels: 4 }")));
}

TEST(Steepness, singular_maps_are_flat_instead) {
    EXPECT_FALSE(is_any_steep(squashed("0.5,0,0.5", 200)));
    EXPECT_FALSE(is_any_steep(squashed("0.5,0,0", 200)));
    EXPECT_TRUE(is_any_steep(squashed("0.5,0,0.0001", 200)));
}

TEST(Steepness, volumes_without_maps_are_not_steep) {
    EXPECT_FALSE(is_any_steep("object o { sphere }"));
}

}  // namespace
}  // namespace pxm::host
