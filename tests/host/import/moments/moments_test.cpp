// Moments by the recursion against moments of points, and Theorem 8.1 on sets that are known.
#include "host/import/moments/moments.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "host/error.hpp"
#include "host/import/moments/collage.hpp"
#include "host/import/moments/moment_search.hpp"
#include "host/import/moments/picture.hpp"

namespace pxm::host {
namespace {

const std::vector<PlaneMap> gasket{
    {.5, 0, 0, .5, 0, 0}, {.5, 0, 0, .5, .5, 0}, {.5, 0, 0, .5, .25, .5}};

/// One point of every cell of that level; their weights are the products of the maps'.
std::vector<WeightedPoint> cells(const std::vector<PlaneMap>& maps,
                                 const std::vector<double>& weights, int level) {
    std::vector<WeightedPoint> points{{0.3, 0.3, 1}};
    for (int n = 0; n < level; ++n) {
        std::vector<WeightedPoint> next;
        for (const WeightedPoint& p : points)
            for (std::size_t k = 0; k < maps.size(); ++k) {
                const PlaneMap& m = maps[k];
                next.push_back({m.a * p.x + m.b * p.y + m.e, m.c * p.x + m.d * p.y + m.f,
                                p.weight * weights[k]});
            }
        points = std::move(next);
    }
    return points;
}

TEST(Moments, are_in_the_order_of_rising_degree) {
    EXPECT_EQ(moment_index(0, 0), 0U);
    EXPECT_EQ(moment_index(1, 0), 1U);
    EXPECT_EQ(moment_index(0, 1), 2U);
    EXPECT_EQ(moment_index(2, 0), 3U);
    EXPECT_EQ(moment_index(0, 2), 5U);
    EXPECT_EQ(moment_count(2), 6U);
}

TEST(Moments, of_the_unit_square_are_known) {
    const std::vector<PlaneMap> square{
        {.5, 0, 0, .5, 0, 0}, {.5, 0, 0, .5, .5, 0}, {.5, 0, 0, .5, 0, .5}, {.5, 0, 0, .5, .5, .5}};
    const PlaneMoments g = invariant_moments(square, determinant_weights(square), 8);
    for (int i = 0; i <= 8; ++i)
        for (int j = 0; i + j <= 8; ++j)
            EXPECT_NEAR(g[moment_index(i, j)], 1.0 / ((i + 1) * (j + 1)), 1e-14);
}

TEST(Moments, of_random_systems_are_those_of_their_points) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> number(-0.35, 0.35);
        std::vector<PlaneMap> maps(3);
        for (PlaneMap& m : maps)
            m = {number(random), number(random), number(random),
                 number(random), number(random), number(random)};
        const std::vector<double> weights{0.2, 0.5, 0.3};
        const PlaneMoments recursion = invariant_moments(maps, weights, 4);
        const PlaneMoments points = moments_of(cells(maps, weights, 9), 4);
        for (std::size_t m = 0; m < points.size(); ++m) EXPECT_NEAR(recursion[m], points[m], 2e-3);
    }
}

TEST(Moments, weights_go_by_the_determinant_and_starve_none) {
    const std::vector<PlaneMap> maps{
        {.5, 0, 0, .5, 0, 0}, {0, 0, 0, .16, 0, 0}, {-.5, 0, 0, 1, 0, 0}};
    const auto weights = determinant_weights(maps);
    EXPECT_NEAR(weights[0] * 2, weights[2], 1e-5);
    EXPECT_GT(weights[1], 0);
    EXPECT_NEAR(weights[0] + weights[1] + weights[2], 1, 1e-15);
}

TEST(Collage, of_an_attractor_is_zero_but_for_the_grid) {
    const auto points = cells(gasket, {1, 1, 1}, 8);
    const GridSet set(points, 100, 0);
    EXPECT_LE(set.collage_distance(gasket), 2 * set.cell());
    EXPECT_EQ(collage_bound(0.1, gasket), 0.2);
}

TEST(Collage, sees_a_part_that_is_not_covered_and_a_copy_that_sticks_out) {
    const auto points = cells(gasket, {1, 1, 1}, 7);
    const GridSet set(points, 100, 0);
    // Without the top copy its apex (0.5,1) is nearest to those of the others, (0.25,0.5).
    EXPECT_NEAR(set.collage_distance(std::span(gasket).first(2)), std::hypot(0.25, 0.5),
                3 * set.cell());
    auto moved = gasket;
    moved[1].e += 3;  // far off the grid
    EXPECT_GE(set.collage_distance(moved), 3 - set.cell());
    EXPECT_LE(set.collage_distance(moved), 3.3);
}

TEST(Collage, the_attractor_is_within_the_bound_of_theorem_8_1) {
    auto maps = gasket;
    maps[0].e += 0.03;
    maps[1].b += 0.05;
    const auto target = cells(gasket, {1, 1, 1}, 7);
    const GridSet set(target, 128, 0);
    const double bound = collage_bound(set.collage_distance(maps), maps);
    const auto attractor = cells(maps, {1, 1, 1}, 7);
    double farthest = 0;
    for (const WeightedPoint& a : attractor) {
        double nearest = 1e300;
        for (const WeightedPoint& b : target)
            nearest = std::min(nearest, std::hypot(a.x - b.x, a.y - b.y));
        farthest = std::max(farthest, nearest);
    }
    EXPECT_LE(farthest, bound + 2 * set.cell());
    EXPECT_GT(farthest, 0.01);
}

LoadedImage image_of(int width, int height, const std::vector<float>& grey) {
    return {{width, height, {"Y"}, {}}, grey};
}

TEST(Picture, ink_is_what_differs_from_the_border) {
    std::vector<float> grey(16, 1.0F);
    grey[5] = 0;     // column 1, row 1
    grey[6] = 0.5F;  // half the ink
    grey[9] = 0.9F;  // too little
    const PlaneMeasure picture = picture_of(image_of(4, 4, grey));
    ASSERT_EQ(picture.points.size(), 2U);
    EXPECT_EQ(picture.points[0].x, -0.25);
    EXPECT_EQ(picture.points[0].y, 0.25);
    EXPECT_EQ(picture.points[0].weight, 1);
    EXPECT_EQ(picture.points[1].weight, 0.5);
    EXPECT_THROW((void)picture_of(image_of(2, 2, {1, 1, 1, 1})), Error);
}

TEST(Picture, points_are_read_from_text) {
    const PlaneMeasure picture =
        read_points("p.xy", "# points\n1 2\n\n-.5,1e-3 ; more\r\n3 4 0.5\n");
    ASSERT_EQ(picture.points.size(), 3U);
    EXPECT_EQ(picture.points[1].y, 1e-3);
    EXPECT_EQ(picture.points[2].weight, 0.5);
    EXPECT_THROW((void)read_points("p.xy", "1\n"), Error);
    EXPECT_THROW((void)read_points("p.xy", "1 2 -1\n"), Error);
    EXPECT_THROW((void)read_points("p.xy", "# nothing\n"), Error);
}

TEST(MomentSearch, the_same_seed_finds_the_same_maps) {
    const auto points = cells(gasket, {1, 1, 1}, 5);
    MomentRequest request;
    request.maps = 3;
    request.finest = 1.0 / 32;
    const MomentResult a = search_moments(points, request);
    const MomentResult b = search_moments(points, request);
    EXPECT_FALSE(a.out_of_time);
    ASSERT_EQ(a.maps.size(), 3U);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(a.maps[k].a, b.maps[k].a);
    EXPECT_LE(a.collage_distance, 3 * a.cell);
}

TEST(MomentSearch, a_single_point_is_no_picture) {
    EXPECT_THROW((void)search_moments(std::vector<WeightedPoint>{{1, 2, 1}}, {}), Error);
}

}  // namespace
}  // namespace pxm::host
