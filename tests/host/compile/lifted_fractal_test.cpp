#include "host/compile/lifted_fractal.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "host/math/lipschitz.hpp"
#include "host/scene/parse/parser.hpp"

namespace pxm::test {
namespace {

using namespace host;

Fractal fractal_of(const std::string& maps) {
    Diagnostics diagnostics;
    const Scene scene = parse_text("test.pxm", "ifs a { " + maps + " }", diagnostics);
    auto fractal = make_fractal(scene.ifs.front(), diagnostics);
    EXPECT_FALSE(diagnostics.has_errors()) << diagnostics.text(scene.files);
    return fractal.value_or(Fractal{});
}

/// Law: with the thickness that rays need, the system still contracts, and it has its volumes.
void expect_liftable(const std::string& maps) {
    Fractal fractal = fractal_of(maps);
    ASSERT_FALSE(fractal.exact.maps.empty());
    for (const double share : {1e-4, 1e-2}) {
        lift_again(fractal, share);
        EXPECT_TRUE(fractal.lifted);
        EXPECT_NE(prove_contraction(fractal.rifs).proof, ContractionProof::none);
        ASSERT_FALSE(fractal.bounds.empty());
        for (const Bounds& bounds : fractal.bounds) EXPECT_TRUE(std::isfinite(bounds.ball.radius));
    }
}

TEST(LiftedFractal, a_strong_shear_gets_no_thickness_that_makes_it_grow) {
    expect_liftable("newmap matrix: 0.5,0,1e7, 0,0.5,0, 0,0,0.5, 0,0,0");
    expect_liftable("newmap matrix: 0.5,0,1e7, 0,0.5,0, 0,0,0.5, 1,2,3");
    expect_liftable("newmap matrix: 0,0,1e9, 0,0.5,0, 0,0,0.5, 1,0,0");
}

TEST(LiftedFractal, a_map_to_a_point_stays_smaller_than_what_the_next_one_stretches) {
    expect_liftable(
        "newmap scale: 0 translate: 1,0,0  newmap scale: 1e5  "
        "follow: 1 -> 2  follow: 2 -> 1");
}

TEST(LiftedFractal, regular_maps_stay_as_they_are) {
    const Fractal fractal = fractal_of("newmap scale: 0.5  newmap scale: 0.5 translate: 1,0,0");
    EXPECT_FALSE(fractal.lifted);
    EXPECT_EQ(fractal.rifs.maps, fractal.exact.maps);
}

}  // namespace
}  // namespace pxm::test
