// Laws of box counting; its error is tried on many systems in box_counting_slow_test.cpp.
#include "host/fractal/dimension/box_counting.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "host/fractal/system/contraction.hpp"
#include "tests/host/fractal/systems.hpp"

namespace pxm::host {
namespace {

using systems::complete;
using systems::homotheties;

BoxCounting boxes_of(const Rifs& rifs) {
    return count_boxes(rifs, bound(rifs, prove_contraction(rifs)));
}

void expect_dimension(const Rifs& rifs, double dimension) {
    const BoxCounting found = boxes_of(rifs);
    ASSERT_TRUE(found.dimension) << found.method;
    EXPECT_NEAR(*found.dimension, dimension, found.error);
    EXPECT_LT(found.error, 0.05);
}

TEST(BoxCounting, errors_hold_known_dimensions) {
    expect_dimension(complete(homotheties(1.0 / 3, {{0, 0, 0}, {2.0 / 3, 0, 0}})),
                     std::log(2) / std::log(3));
    expect_dimension(complete(homotheties(0.5, {{0, 0, 0}, {0.5, 0, 0}})), 1);
    expect_dimension(systems::with_graph(homotheties(0.5, {{0, 0, 0}, {0.5, 0, 0}}), {{0, 1}, {0}}),
                     std::log(std::numbers::phi) / std::log(2));
}

TEST(BoxCounting, counts_the_boxes_that_there_are) {
    for (const BoxScale& scale :
         boxes_of(complete(homotheties(0.5, {{0, 0, 0}, {0.5, 0, 0}}))).scales) {
        const double boxes = 1 / scale.side + 1;  // on average over the places of the grid
        EXPECT_NEAR(scale.boxes, boxes, 0.2 * boxes) << scale.side;
    }
}

TEST(BoxCounting, is_the_same_each_time) {
    const Rifs rifs = complete(homotheties(0.25, {{0, 0, 0}, {0.75, 0, 0}}));
    EXPECT_EQ(boxes_of(rifs).dimension, boxes_of(rifs).dimension);
}

TEST(BoxCounting, single_points_have_dimension_0) {
    EXPECT_EQ(boxes_of(complete(homotheties(0.5, {{1, 2, 3}}))).dimension, 0);
    EXPECT_EQ(boxes_of(systems::with_graph(homotheties(0.5, {{0, 0, 0}, {1, 0, 0}}), {{1}, {0}}))
                  .dimension,
              0);
}

TEST(BoxCounting, none_is_printed_where_there_are_too_many_cells) {
    std::vector<glm::dvec3> offsets;  // each place is met by more words at each finer scale
    for (int i = 0; i < 12; ++i) offsets.push_back({0.1 * std::cos(i), 0.1 * std::sin(i), 0});
    const BoxCounting found = boxes_of(complete(homotheties(0.9, offsets)));
    EXPECT_FALSE(found.dimension);
    EXPECT_EQ(found.method, "not measured: more cells than the limit allows to look at");
}

}  // namespace
}  // namespace pxm::host
